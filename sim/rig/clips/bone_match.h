#pragma once

#include <vector>

#include "sim/rig/actor.h"
#include "sim/rig/figure.h"

namespace knuckle {

/// The actor's bodies as bones, with the same indices, at their joints; crosses have no name and nothing hangs on them.
Model skeletonOf(const Actor& actor);

/// The anatomy of an actor's bodies.
struct ActorAnatomy {
    Model skeleton;                  ///< Of skeletonOf().
    std::vector<BoneAnatomy> bones;  ///< One a body.
    bool isFacingKnown = false;      ///< As of isFacingKnown().
};

/// Its sides follow the direction in which the actor's particles face.
ActorAnatomy anatomyOf(const Actor& actor);

/// Per body of the actor, the bone of another skeleton that moves it, NO_INDEX for none.
std::vector<uint32_t> matchBones(const ActorAnatomy& actor, const Figure& source);

}  // namespace knuckle
