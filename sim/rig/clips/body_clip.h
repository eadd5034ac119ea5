#pragma once

#include <string>
#include <vector>

#include "sim/rig/actor.h"
#include "sim/rig/figure.h"
#include "sim/rig/model.h"
#include "sim/world/animation/animation.h"

namespace knuckle {

/// A clip of a skeleton as a motion of an actor's bodies, whose joints hold: of what a bone does, hinges take the turn
/// about their axis and stiff joints none.
struct ActorClip {
    BodyClip clip;
    std::vector<std::string> notes;  ///< What of it does not fit, one sentence each.
};

/// The point of the first body whose way a clip keeps: the middle of its joints, at rest [m].
Vector3f pivotOf(const Actor& actor);

/// Of the model that the actor is made of.
ActorClip ownClip(const Actor& actor, const Model& model, const Clip& clip);

/// Of another skeleton: bones that have the same name, but for a prefix and case, or are the same part of a body, turn
/// what they are of the actor. Limbs that point elsewhere at rest are turned to match, heights are scaled by those of
/// the hips, and the way begins where the actor stands. @throws InputError where no bone fits, with names of both.
ActorClip foreignClip(const Actor& actor, const Figure& source, const Clip& clip);

/// Of one body against the one that it hangs on, key by key.
std::vector<Quaternionf> turnsOf(const BodyClip& clip, uint32_t body);

}  // namespace knuckle
