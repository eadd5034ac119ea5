#pragma once

#include <string>
#include <vector>

#include "sim/world/world.h"

namespace knuckle {

/// A sentence for each material of which soft bodies cannot show all the stiffness or damping at their substeps.
std::vector<std::string> softLimits(const World& world);

}  // namespace knuckle
