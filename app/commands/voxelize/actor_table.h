#pragma once

#include <string>

#include "sim/rig/actor.h"
#include "sim/rig/actor_options.h"
#include "sim/rig/figure.h"
#include "sim/rig/limbs/fill_error.h"

namespace knuckle {

/// The output of `knuckle voxelize`: a line for each body, with its joint, the joint's range, its part of a body and
/// how that is known; number and size of all, the pose, the clips; and what was merged, repaired or assumed.
/// @param options that the actor was made with.
std::string actorTable(const Actor& actor, const Figure& figure, const ArticulationOptions& options,
                       const FillError& fill);

}  // namespace knuckle
