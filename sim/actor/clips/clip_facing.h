#pragma once

#include <vector>

#include "sim/actor/actor.h"
#include "sim/actor/model.h"

namespace knuckle {

/// The turn about the vertical from where another skeleton looks at rest to where the actor does.
/// @param bones of matchBones().
Quaternionf facingOf(const Actor& actor, const Model& source, const std::vector<uint32_t>& bones);

}  // namespace knuckle
