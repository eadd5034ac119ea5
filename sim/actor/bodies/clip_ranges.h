#pragma once

#include <string>

#include "sim/actor/bodies/articulate.h"
#include "sim/world/animation/animation.h"

namespace knuckle {

/// Widens the limits of an actor's joints so that they take in every turn of the model's clips, with 5 degrees to
/// spare, those of both sides alike, but for what lastingTurns() leaves out, which is a note. What is no part of a
/// person's body has limits that are GUESSED. Limits that somebody gave stay as they are.
void takeInClips(const Model& model, const ArticulationOptions& options, Actor& actor);

/// Leaves out of a clip what the limits of its actor's joints are not widened for, before takeIn(): what lastingTurns()
/// leaves out is held where the limits will be. @returns a sentence about it, empty where all of the clip fits.
std::string holdWithinLimits(const Actor& actor, BodyClip& clip);

/// Makes an actor fit for a clip: widens its joints' limits so that they take in every turn of it, with 5 degrees to
/// spare, and lets bodies that overlap in most of it never touch.
void takeIn(Actor& actor, const BodyClip& clip);

}  // namespace knuckle
