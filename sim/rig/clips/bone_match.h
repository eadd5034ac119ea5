#pragma once

#include <vector>

#include "sim/rig/actor.h"
#include "sim/rig/figure.h"

namespace knuckle {

/// The actor's bodies as bones, index for index, at their joints; crosses have no name and nothing hangs on them.
Model skeletonOf(const Actor& actor);

/// What an actor's bodies are.
struct ActorAnatomy {
    Model skeleton;                  ///< Of skeletonOf().
    std::vector<BoneAnatomy> bones;  ///< One a body.
    bool isFacingKnown = false;      ///< As of isFacingKnown().
};

/// With the sides that it has as its particles show where it looks.
ActorAnatomy anatomyOf(const Actor& actor);

/// Per body of the actor the bone of another skeleton that moves it, NO_INDEX for none.
std::vector<uint32_t> matchBones(const ActorAnatomy& actor, const Figure& source);

}  // namespace knuckle
