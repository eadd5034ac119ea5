#pragma once

#include <Eigen/Core>

#include "sim/world/world.h"

namespace knuckle {

/// The best direction to look at a scene from, towards the camera, unit: a little from the right, a little from above;
/// from higher where boxes, as the walls of a container, would hide what is between them.
Eigen::Vector3f pleasantDirection(const World& world);

}  // namespace knuckle
