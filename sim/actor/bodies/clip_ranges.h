#pragma once

#include "sim/actor/bodies/articulate.h"

namespace knuckle {

/// Widens the limits of an actor's joints so that they take in every turn of the model's clips, with 5 degrees to
/// spare, those of both sides alike. Limits that somebody gave stay as they are.
void takeInClips(const Model& model, const ArticulationOptions& options, Actor& actor);

}  // namespace knuckle
