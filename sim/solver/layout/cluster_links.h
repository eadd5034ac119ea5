#pragma once

#include <Eigen/Core>
#include <vector>

#include "shared/gpu_types.h"
#include "sim/world/world.h"

namespace knuckle {

/// Appends the links of clusters of soft bodies to those of bodies.
void appendClusterLinks(std::vector<gpu::ParticleRigidBodyLink>& links, const World& world);

/// The spread of a cluster's links about their centre.
struct ClusterMoments {
    double mass = 0.0;     ///< [kg]
    double bending = 0.0;  ///< What holds a bend within it, per mass and Young's modulus over density [1/m2].
    Eigen::Matrix3d inverse = Eigen::Matrix3d::Zero();  ///< Of the sum of m r r^T, where it has one.
    Eigen::Matrix3d empty = Eigen::Matrix3d::Zero();    ///< Projects on directions without particles.
};

ClusterMoments clusterMoments(const World& world, const Cluster& cluster);

}  // namespace knuckle
