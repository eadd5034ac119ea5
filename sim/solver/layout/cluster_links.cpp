#include "sim/solver/layout/cluster_links.h"

#include <Eigen/Eigenvalues>
#include <algorithm>

namespace knuckle {

using Eigen::Matrix3d;
using Eigen::Vector3d;

ClusterMoments clusterMoments(const World& world, const Cluster& cluster)
{
    ClusterMoments out;
    Matrix3d sum = Matrix3d::Zero();
    for (uint32_t l = cluster.linkStart; l < cluster.linkStart + cluster.linkCount; ++l) {
        const Vector3d r = world.clusterLinks[l].restOffset.cast<double>();
        out.mass += world.clusterLinks[l].mass;
        sum += world.clusterLinks[l].mass * r * r.transpose();
    }
    // A layer two particles thick has an extent of a quarter of a diameter squared; flatter clusters count as that
    // thick.
    const double thin = 0.25 * world.diameter() * world.diameter();
    out.extent = std::max(sum.trace() / (3.0 * out.mass), thin);
    const Eigen::SelfAdjointEigenSolver<Matrix3d> eigen(sum / out.mass);
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
