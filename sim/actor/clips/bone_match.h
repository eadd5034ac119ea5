#pragma once

#include "sim/actor/actor.h"
#include "sim/actor/model.h"

namespace knuckle {

/// The actor's bodies as bones, index for index, at their joints; crosses have no name and nothing hangs on them.
Model skeletonOf(const Actor& actor);

/// Per body of the actor the bone of another skeleton that moves it, NO_INDEX for none.
std::vector<uint32_t> matchBones(const Actor& actor, const Model& source);

}  // namespace knuckle
