#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace knuckle {

using Eigen::Quaternionf;
using Eigen::Vector3f;

/// A rigid pose: x -> rotation * x + translation.
struct Pose {
    Vector3f translation{0, 0, 0};
    Quaternionf rotation{1, 0, 0, 0};  ///< Eigen's constructor order is wxyz.
    Vector3f apply(const Vector3f& p) const { return rotation * p + translation; }
};

}  // namespace knuckle
