#pragma once

#include <Eigen/Core>
#include <string>

#include "sim/rig/model.h"

namespace knuckle {

/// A walking machine made from nothing but this code: six legs of three stiff segments each about a body 0.3 m above
/// y = 0, facing +z; 21 bones, each with a closed shell of its own, and the clip "walk", which goes on where it has
/// come to: three legs stand while the other three step, at half a metre a second.
Model makeSpider();

/// Where the foot at the end of a tibia stands at rest: the middle of its ball [m].
Eigen::Vector3f spiderFoot(const std::string& tibia);

}  // namespace knuckle
