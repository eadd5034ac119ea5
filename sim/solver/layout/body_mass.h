#pragma once

#include <Eigen/Core>
#include <vector>

#include "sim/world/world.h"

namespace knuckle {

/// How the links of a body are spread, in the body's own frame about its centre of shape matching.
struct BodyMass {
    double mass = 0.0;                                         ///< [kg]
    double radius = 0.0;                                       ///< To the farthest particle's centre [m].
    Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();         ///< Sum of m r r^T [kg m2].
    Eigen::Matrix3d inverseInertia = Eigen::Matrix3d::Zero();  ///< Zero if it cannot turn [1/(kg m2)].
};

BodyMass bodyMass(const World& world, const Body& body);

/// Per link, the largest inverse mass that an impulse on its particle can meet in the body: 1/M plus the largest
/// eigenvalue of [r] I^-1 [r]^T [1/kg].
std::vector<float> worstInverseMasses(const World& world);

}  // namespace knuckle
