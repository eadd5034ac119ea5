#pragma once

#include "sim/actor/bodies/articulate.h"
#include "sim/world/animation/animation.h"

namespace knuckle {

/// Widens the limits of an actor's joints so that they take in every turn of the model's clips, with 5 degrees to
/// spare, those of both sides alike; of hinges lastingTurns(), and what is left out is a note. Limits that somebody
/// gave
/// stay as they are.
void takeInClips(const Model& model, const ArticulationOptions& options, Actor& actor);

/// Makes an actor fit for a clip: widens its joints' limits so that they take in every turn of it, with 5 degrees to
/// spare, and lets bodies that overlap in most of it never touch.
void takeIn(Actor& actor, const BodyClip& clip);

}  // namespace knuckle
