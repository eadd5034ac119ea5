#pragma once

#include <string>

#include "sim/actor/actor.h"
#include "sim/actor/bodies/articulate.h"
#include "sim/actor/limbs/fill_error.h"
#include "sim/actor/model.h"

namespace knuckle {

/// What `knuckle voxelize` prints: a line for each body, with how it is joined and how far that turns, what of a body
/// its bone was taken for and by what; how many and how large it all is, the pose, the clips; and what was merged,
/// repaired or assumed.
/// @param options with which the actor was made of the model.
std::string actorTable(const Actor& actor, const Model& model, const ArticulationOptions& options,
                       const FillError& fill);

}  // namespace knuckle
