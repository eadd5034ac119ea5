#include "sim/solver/layout/body_mass.h"

#include <Eigen/Eigenvalues>
#include <algorithm>

namespace knuckle {

using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

Matrix3d inverseOf(const Matrix3d& inertia)
{
    const Eigen::SelfAdjointEigenSolver<Matrix3d> eigen(inertia);
    const double largest = std::max(eigen.eigenvalues().maxCoeff(), 1e-30);
    Vector3d inverse = Vector3d::Zero();
    for (int k = 0; k < 3; ++k)
        if (eigen.eigenvalues()[k] > 1e-6 * largest) inverse[k] = 1.0 / eigen.eigenvalues()[k];
    return eigen.eigenvectors() * inverse.asDiagonal() * eigen.eigenvectors().transpose();
}

/// Sum of m r r^T of a solid ball or capsule along y [kg m2].
Matrix3d roundMoments(const RoundShape& round, double mass)
{
    const double r = round.radius, h = round.halfHeight, caps = mass * 4.0 / 3.0 * r / (4.0 / 3.0 * r + 2.0 * h);
    const double middle = mass - caps, across = middle * r * r / 4.0 + caps * r * r / 5.0;
    const double along = middle * h * h / 3.0 + caps * (r * r / 5.0 + h * h + 0.75 * h * r);
    return Vector3d(across, along, across).asDiagonal();
}

/// Particles in a line have no inertia about it; this adds that of balls and keeps the others, since contacts and
/// joints beside the line can turn them about it. @param moments their sum of m r r^T [kg m2].
Matrix3d thickened(const Matrix3d& moments, double mass, double diameter)
{
    const Eigen::SelfAdjointEigenSolver<Matrix3d> eigen(moments);
    const Vector3d& spread = eigen.eigenvalues();
    const Vector3d along = eigen.eigenvectors().col(2);
    const double ball = mass * diameter * diameter / 20.0;
    if (spread[1] > 1e-6 * spread[2] || spread[2] <= ball) return moments;
    return moments + ball * (Matrix3d::Identity() - 2.0 * along * along.transpose());
}

}  // namespace

BodyMass bodyMass(const World& world, const Body& body)
{
    BodyMass result;
    for (uint32_t l = body.linkStart; l < body.linkStart + body.linkCount; ++l) {
        const Vector3d r = world.links[l].restOffset.cast<double>();
        result.mass += world.links[l].mass;
        result.moments += world.links[l].mass * r * r.transpose();
        result.radius = std::max(result.radius, r.norm());
    }
    result.moments = thickened(result.moments, result.mass, world.diameter());
    if (body.round.exists()) {
        result.moments = roundMoments(body.round, result.mass);
        result.radius = body.round.radius + body.round.halfHeight - world.particleRadius;
    }
    result.inverseInertia = inverseOf(result.moments.trace() * Matrix3d::Identity() - result.moments);
    return result;
}

std::vector<float> worstInverseMasses(const World& world)
{
    std::vector<float> result(world.links.size(), 0.0f);
    for (const Body& body : world.bodies) {
        const BodyMass mass = bodyMass(world, body);
        for (uint32_t l = body.linkStart; l < body.linkStart + body.linkCount; ++l) {
            const Vector3d r = world.links[l].restOffset.cast<double>();
            Matrix3d cross;
            cross << 0, -r.z(), r.y(), r.z(), 0, -r.x(), -r.y(), r.x(), 0;
            const Matrix3d turn = cross * mass.inverseInertia * cross.transpose();
            const double largest = Eigen::SelfAdjointEigenSolver<Matrix3d>(turn).eigenvalues().maxCoeff();
            result[l] = static_cast<float>(1.0 / mass.mass + std::max(largest, 0.0));
        }
    }
    return result;
}

}  // namespace knuckle
