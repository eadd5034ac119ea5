#pragma once

#include <Eigen/Core>
#include <string>

#include "sim/rig/model.h"

namespace knuckle {

/// A walking machine generated entirely by this code: six legs of three stiff segments each about a body 0.3 m above y
/// = 0, facing +z; 21 bones, each with its own closed shell, and the clip "walk", which continues from where it ends:
/// three legs stand while the other three step, at half a metre a second.
Model makeSpider();

/// Place at rest of the foot at the end of a tibia: the middle of its ball [m].
Eigen::Vector3f spiderFoot(const std::string& tibia);

}  // namespace knuckle
