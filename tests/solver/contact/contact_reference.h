#pragma once

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <functional>

#include "shared/contact_constants.h"
#include "tests/solver/solver_test.h"

namespace knuckle::test {

/// Inverse masses that an impulse on a body meets at a place, all in the body's axes
/// (shaders/sim/contact/contact_mass.glsl).
struct SideMass {
    double normal;  ///< Along the normal [1/kg].
    double worst;   ///< The larger of that and the one along the worst tangent [1/kg].
};

inline SideMass sideMass(double inverseMass, const Matrix3d& inverseInertia, const Vector3d& r, const Vector3d& normal)
{
    Matrix3d cross;
    cross << 0, -r.z(), r.y(), r.z(), 0, -r.x(), -r.y(), r.x(), 0;
    const Matrix3d all = inverseMass * Matrix3d::Identity() - cross * inverseInertia * cross;
    const Eigen::Matrix<double, 3, 2> tangents = normal.unitOrthogonal() * Eigen::RowVector2d(1, 0) +
                                                 normal.cross(normal.unitOrthogonal()) * Eigen::RowVector2d(0, 1);
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> eigen(tangents.transpose() * all * tangents);
    const double along = normal.dot(all * normal);
    return {along, std::max(along, eigen.eigenvalues()[1])};
}

/// The part of a particle that touches a collider, in its body's axes
/// (shaders/sim/common/contacts/collider_point.glsl).
struct ColliderTouch {
    Vector3d r;           ///< The particle's centre, or the corner of its box [m].
    double radius = 0.0;  ///< How far its surface is from there [m].
    bool sure = true;     ///< Not so near a limit that rounding decides.
};

/// @param ends latticeEnds of the particle. @param place of a point of the body. @param normal in the body's axes at
/// the particle. @param distance of a place to the collider [m].
inline ColliderTouch colliderTouch(uint32_t ends, const Vector3d& particle, const Vector3d& normal,
                                   const std::function<Vector3d(const Vector3d&)>& place,
                                   const std::function<double(const Vector3d&)>& distance)
{
    ColliderTouch ball{particle, DIAMETER / 2};
    if (ends == LATTICE_ENDS || ends == 0) return ball;
    Vector3d corner = particle;
    for (int axis = 0; axis < 3; ++axis) {
        const bool low = ends >> 2 * axis & 1, high = ends >> (2 * axis + 1) & 1;
        const double lower = std::clamp(-normal[axis] / UPRIGHT, -1.0, 1.0);
        corner[axis] += DIAMETER / 2 * (low && high ? lower : double(high) - double(low));
    }
    const double nearer = distance(place(particle)) - DIAMETER / 2 + CORNER_TIE * DIAMETER - distance(place(corner));
    ColliderTouch touch = nearer > 0.0 ? ColliderTouch{corner, 0.0} : ball;
    touch.sure = std::abs(nearer) > 1e-5 * DIAMETER;
    return touch;
}

}  // namespace knuckle::test
