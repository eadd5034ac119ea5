#include "sim/solver/layout/cluster_links.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace knuckle {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// Bent by a curvature c, a cluster's particles at (x, y) move by c x y along x: bending E / density / 2 times the sum
// of m (c x y)^2. A beam takes E / density / 2 times the sum of m c^2 (y^2 + d^2 / 12), particles being cubes of d. So
// bending is (1 + d^2 / (12 y^2)) / x^2, of mean squares. Where clusters share the layers at both ends, x^2 is d^2 / 2.
ClusterMoments clusterMoments(const World& world, const Cluster& cluster)
{
    ClusterMoments out;
    Matrix3d sum = Matrix3d::Zero();
    for (uint32_t l = cluster.linkStart; l < cluster.linkStart + cluster.linkCount; ++l) {
        const Vector3d r = world.clusterLinks[l].restOffset.cast<double>();
        out.mass += world.clusterLinks[l].mass;
        sum += world.clusterLinks[l].mass * r * r.transpose();
    }
    const Eigen::SelfAdjointEigenSolver<Matrix3d> eigen(sum / out.mass);
    // Layers two particles thick have a mean square of a quarter of a diameter squared; flatter ones count as that.
    const double square = std::pow(double(world.diameter()), 2), thin = 0.25 * square;
    const double across = std::max(eigen.eigenvalues()[0], thin), along = std::max(across, 0.5 * square);
    out.bending = (1.0 + square / (12.0 * across)) / along;
    for (int k = 0; k < 3; ++k) {
        const Vector3d axis = eigen.eigenvectors().col(k);
        const double value = eigen.eigenvalues()[k];
        if (value > 0.01 * thin) out.inverse += axis * axis.transpose() / (out.mass * value);
        else out.empty += axis * axis.transpose();
    }
    return out;
}

void appendClusterLinks(std::vector<gpu::ParticleRigidBodyLink>& links, const World& world)
{
    const auto bodies = static_cast<uint32_t>(links.size());
    for (const Link& link : world.clusterLinks) {
        const Cluster& cluster = world.clusters[link.body];
        const Vector3f& r = link.restOffset;
        links.push_back(
            {link.particle, link.body, r.x(), r.y(), r.z(), bodies + cluster.linkStart, cluster.linkCount, link.mass});
    }
}

}  // namespace knuckle
