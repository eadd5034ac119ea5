#pragma once

#include <span>

#include "sim/rig/anatomy/clip_turns.h"
#include "sim/rig/joints/joint_ranges.h"

namespace knuckle {

/// The direction in which a hinged limb folds: as clips bend it, unless the rest pose already shows nearly that; else
/// as it is bent at rest; else knees back, fingers to the palm, everything else forward. An upright figure's limbs that
/// are slightly bent the other way at rest fold like a body's. For a creature no direction counts as wrong.
/// @param clips how it turns against its parent.
/// @returns unit and across the limb.
Vector3f foldDirection(const LimbStance& limb, std::span<const Turns> clips);

/// How far a limb is bent from straight in that direction [rad]; 0 if nothing is known above it.
float restBend(const LimbStance& limb, const Vector3f& axis);

}  // namespace knuckle
