#include "tools/shapes/distance.h"

#include <algorithm>
#include <cmath>

namespace knuckle {

using Eigen::Vector3d;

double segmentParameter(const Vector3d& p, const Vector3d& a, const Vector3d& b)
{
    return std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
}

double segmentDistance(const Vector3d& p, const Vector3d& a, const Vector3d& b)
{
    return (p - a - segmentParameter(p, a, b) * (b - a)).norm();
}

double limbDistance(const Vector3d& p, const Limb& limb)
{
    const double t = segmentParameter(p, limb.a, limb.b);
    return segmentDistance(p, limb.a, limb.b) - (limb.radiusA + t * (limb.radiusB - limb.radiusA));
}

double ellipsoidDistance(const Vector3d& p, const Vector3d& centre, const Vector3d& radii)
{
    return ((p - centre).cwiseQuotient(radii).norm() - 1.0) * radii.minCoeff();
}

double melt(double a, double b, double width)
{
    const double h = std::max(width - std::abs(a - b), 0.0) / width;
    return std::min(a, b) - 0.25 * width * h * h;
}

}  // namespace knuckle
