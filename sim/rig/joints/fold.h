#pragma once

#include <span>

#include "sim/rig/anatomy/clip_turns.h"
#include "sim/rig/joints/joint_ranges.h"

namespace knuckle {

/// Which way a hinged limb folds: how clips bend it, unless the rest pose already shows nearly that; else how it is
/// bent at rest; else knees back, fingers to the palm, everything else forward. An upright figure's limbs that are
/// slightly bent the other way at rest fold as those of a body do. Of a creature nobody knows which way is wrong.
/// @param clips how it turns against its parent.
/// @returns unit and across the limb.
Vector3f foldDirection(const LimbStance& limb, std::span<const Turns> clips);

/// How far a limb is bent from straight, that way [rad]; 0 where nothing is known above it.
float restBend(const LimbStance& limb, const Vector3f& axis);

}  // namespace knuckle
