#pragma once

#include <string>

#include "sim/rig/actor.h"
#include "sim/rig/actor_options.h"
#include "sim/rig/figure.h"
#include "sim/rig/limbs/fill_error.h"

namespace knuckle {

/// What `knuckle voxelize` prints: a line for each body, with how it is joined and how far that turns, what of a body
/// its bone was taken for and by what; how many and how large it all is, the pose, the clips; and what was merged,
/// repaired or assumed.
/// @param options with which the actor was made of the figure.
std::string actorTable(const Actor& actor, const Figure& figure, const ArticulationOptions& options,
                       const FillError& fill);

}  // namespace knuckle
