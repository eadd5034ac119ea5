#pragma once

#include <vector>

#include "sim/rig/clips/bone_match.h"

namespace knuckle {

/// The turn about the vertical from the direction that another skeleton faces at rest to that of the actor.
/// @param bones of matchBones().
Quaternionf facingOf(const ActorAnatomy& actor, const Figure& source, const std::vector<uint32_t>& bones);

}  // namespace knuckle
