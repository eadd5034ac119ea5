#pragma once

#include <string>
#include <vector>

#include "sim/rig/actor.h"
#include "sim/rig/figure.h"
#include "sim/rig/model.h"
#include "sim/world/animation/animation.h"

namespace knuckle {

/// A clip of a skeleton as a motion of an actor's bodies that keeps joints together: hinges take only a bone's turn
/// about their axis, stiff joints nothing.
struct ActorClip {
    BodyClip clip;
    std::vector<std::string> notes;  ///< What does not fit, one sentence each.
};

/// The point of the first body whose path a clip keeps: the middle of its joints, at rest [m].
Vector3f pivotOf(const Actor& actor);

/// A clip of the model that the actor is made of.
ActorClip ownClip(const Actor& actor, const Model& model, const Clip& clip);

/// A clip of another skeleton: its bones turn the actor's bodies that have the same name, up to a prefix and case, or
/// are the same part of a body. Limbs that point elsewhere at rest are turned to match, heights are scaled by those of
/// the hips, and the motion begins where the actor stands. @throws InputError if no bone fits, with names of both.
ActorClip foreignClip(const Actor& actor, const Figure& source, const Clip& clip);

/// Turns of one body against the one that it hangs on, key by key.
std::vector<Quaternionf> turnsOf(const BodyClip& clip, uint32_t body);

}  // namespace knuckle
