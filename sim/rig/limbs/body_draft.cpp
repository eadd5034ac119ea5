#include "sim/rig/limbs/body_draft.h"

#include <Eigen/Eigenvalues>

namespace knuckle {

using Eigen::Vector3f;

namespace {

constexpr size_t SPACE_POINTS = 4;  // the fewest that can span space

}  // namespace

bool spansSpace(const std::vector<Vector3f>& points, float diameter)
{
    if (points.size() < SPACE_POINTS) return false;
    Vector3f mean = Vector3f::Zero();
    for (const Vector3f& p : points) {
        mean += p / static_cast<float>(points.size());
    }
    Eigen::Matrix3f covariance = Eigen::Matrix3f::Zero();
    for (const Vector3f& p : points) {
        covariance += (p - mean) * (p - mean).transpose() / static_cast<float>(points.size());
    }
    const float thinnest = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3f>(covariance).eigenvalues()[0];
    return thinnest > 0.01f * diameter * diameter;
}

}  // namespace knuckle
