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

double boxDistance(const Vector3d& p, const Vector3d& centre, const Vector3d& half, double rounding)
{
    const Vector3d beyond = (p - centre).cwiseAbs() - half + Vector3d::Constant(rounding);
    return beyond.cwiseMax(0.0).norm() + std::min(beyond.maxCoeff(), 0.0) - rounding;
}

double cylinderDistance(const Vector3d& p, const Vector3d& a, const Vector3d& b, double radius, double rounding)
{
    const Vector3d axis = (b - a).normalized(), off = p - 0.5 * (a + b);
    const double along = std::abs(off.dot(axis)) - 0.5 * (b - a).norm() + rounding;
    const double out = (off - off.dot(axis) * axis).norm() - radius + rounding;
    return std::hypot(std::max(along, 0.0), std::max(out, 0.0)) + std::min(std::max(along, out), 0.0) - rounding;
}

double melt(double a, double b, double width)
{
    const double h = std::max(width - std::abs(a - b), 0.0) / width;
    return std::min(a, b) - 0.25 * width * h * h;
}

}  // namespace knuckle
