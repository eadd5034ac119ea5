#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "sim/rig/actor.h"
#include "sim/rig/actor_options.h"
#include "sim/rig/figure.h"

namespace knuckle {

/// An actor of a figure for each number of particles, all with the bodies and joints of the first, the coarsest.
/// @param path of the model. @param levels 0: the diameter of the options decides, or the figure. @throws InputError
/// where no scene can have one, or where it cannot have the same bodies.
std::vector<Actor> actorsOfLevels(const std::string& path, const Figure& figure, std::span<const uint32_t> levels,
                                  ActorOptions options);

}  // namespace knuckle
