#pragma once

#include <Eigen/Core>
#include <functional>

namespace knuckle {

/// The signed distance from a surface, or an approximation: negative inside [m].
using Distance = std::function<double(const Eigen::Vector3d&)>;

/// A capsule whose radius changes from one end to the other [m].
struct Limb {
    Eigen::Vector3d a, b;
    double radiusA, radiusB;
};

/// The position along a segment of its point nearest to `p`, 0 ... 1.
double segmentParameter(const Eigen::Vector3d& p, const Eigen::Vector3d& a, const Eigen::Vector3d& b);
double segmentDistance(const Eigen::Vector3d& p, const Eigen::Vector3d& a, const Eigen::Vector3d& b);
double limbDistance(const Eigen::Vector3d& p, const Limb& limb);
/// A lower bound of the true distance.
double ellipsoidDistance(const Eigen::Vector3d& p, const Eigen::Vector3d& centre, const Eigen::Vector3d& radii);
/// A box with rounded edges. @param half of its sides, including roundings [m].
double boxDistance(const Eigen::Vector3d& p, const Eigen::Vector3d& centre, const Eigen::Vector3d& half,
                   double rounding);
/// A cylinder with rounded edges, from `a` to `b`.
double cylinderDistance(const Eigen::Vector3d& p, const Eigen::Vector3d& a, const Eigen::Vector3d& b, double radius,
                        double rounding);
/// Polynomial smooth minimum: shapes blend into each other over `width` > 0 [m].
double melt(double a, double b, double width);

}  // namespace knuckle
