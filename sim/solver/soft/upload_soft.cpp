#include "sim/solver/soft/upload_soft.h"

#include <Eigen/Eigenvalues>
#include <algorithm>

#include "sim/solver/pack.h"

namespace knuckle {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Lame's two over the density, and what is worked out of them.
gpu::GpuSoftMatter matterOf(const World& world, const SoftBody& soft)
{
    const Material& material = world.materials[soft.material];
    const Elasticity& e = material.elasticity;
    const float ratio = e.stiffness / material.density, nu = e.poissonRatio;
    gpu::GpuSoftMatter out{};
    out.shear = ratio / (1.0f + nu);
    out.dilation = ratio * nu / ((1.0f + nu) * (1.0f - 2.0f * nu));
    out.damping = e.damping;
    out.yield = e.yield;
    out.creep = e.creep;
    out.maxDeformation = e.maxDeformation;
    return out;
}

/// The most that a cluster's pull on a particle grows by with its displacement, per mass [1/s2].
double steepness(const gpu::GpuSoftMatter& matter, const ClusterMoments& moments)
{
    const double hardest = moments.mass * moments.inverse.selfadjointView<Eigen::Lower>().eigenvalues().maxCoeff();
    const double flowed = matter.creep > 0.0f ? 1.0 + matter.maxDeformation : 1.0;
    return std::max(double(matter.shear + 3.0f * matter.dilation) * hardest * flowed * flowed,
                    matter.shear / moments.extent);
}

void addMoments(std::vector<gpu::vec4>& out, const ClusterMoments& m)
{
    const Eigen::Matrix3f inverse = m.inverse.cast<float>(), empty = m.empty.cast<float>();
    out.push_back(pack(inverse.diagonal(), static_cast<float>(m.mass)));
    out.push_back({inverse(0, 1), inverse(0, 2), inverse(1, 2), static_cast<float>(1.0 / m.extent)});
    out.push_back(pack(empty.diagonal(), 0));
    out.push_back({empty(0, 1), empty(0, 2), empty(1, 2), 0});
}

void uploadClusters(SolverBuffers& out, const World& world)
{
    std::vector<gpu::ClusterInfo> infos;
    std::vector<gpu::vec4> moments, rests;
    std::vector<gpu::GpuSoftMatter> matter;
    for (const SoftBody& soft : world.softBodies) {
        matter.push_back(matterOf(world, soft));
        std::vector<double> steep(soft.particleCount);   // of each particle, by the shares of its mass
        for (uint32_t c = soft.clusterStart; c < soft.clusterStart + soft.clusterCount; ++c) {
            const Cluster& cluster = world.clusters[c];
            infos.push_back({cluster.linkStart + out.parameters.linkCount, cluster.linkCount, cluster.softBody,
                             soft.assembly});
            const ClusterMoments m = clusterMoments(world, cluster);
            addMoments(moments, m);
            for (int column = 0; column < 3; ++column) rests.push_back(pack(Vector3f::Unit(column), 0));
            for (uint32_t l = cluster.linkStart; l < cluster.linkStart + cluster.linkCount; ++l) {
                const Link& link = world.clusterLinks[l];
                steep[link.particle - soft.particleStart] +=
                    steepness(matter.back(), m) * link.mass / world.particles[link.particle].mass;
            }
        }
        if (!steep.empty()) matter.back().steepest = static_cast<float>(*std::max_element(steep.begin(), steep.end()));
    }
    const size_t count = infos.size();
    std::vector<gpu::vec4> rotations;
    for (const Cluster& cluster : world.clusters) {
        const Quaternionf q = world.softBodies[cluster.softBody].rotation;
        rotations.push_back(pack(q.vec(), q.w()));
    }
    out.clusterInfo = {"clusterInfo", std::span<const gpu::ClusterInfo>(infos)};
    out.clusterMoments = {"clusterMoments", std::span<const gpu::vec4>(moments)};
    out.clusterRests = {"clusterRests", std::span<const gpu::vec4>(rests)};
    out.clusterRotations = {"clusterRotations", std::span<const gpu::vec4>(rotations)};
    out.softMatter = {"softMatter", std::span<const gpu::GpuSoftMatter>(matter)};
    out.clusterPulls = {"clusterPulls", 5 * count};
    out.parameters.clusterCount = static_cast<uint32_t>(count);
}

}  // namespace

ClusterMoments clusterMoments(const World& world, const Cluster& cluster)
{
    ClusterMoments out;
    Matrix3d sum = Matrix3d::Zero();
    for (uint32_t l = cluster.linkStart; l < cluster.linkStart + cluster.linkCount; ++l) {
        const Vector3d r = world.clusterLinks[l].restOffset.cast<double>();
        out.mass += world.clusterLinks[l].mass;
        sum += world.clusterLinks[l].mass * r * r.transpose();
    }
    // A layer two particles thick has an extent of a quarter of a diameter squared; what is flatter counts as that.
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
        links.push_back({link.particle, link.body, r.x(), r.y(), r.z(), bodies + cluster.linkStart, cluster.linkCount,
                         link.mass});
    }
}

void uploadSoftBodies(SolverBuffers& out, const World& world)
{
    uploadClusters(out, world);
    std::vector<std::vector<uint32_t>> linksOf(world.particles.size());
    for (uint32_t l = 0; l < world.clusterLinks.size(); ++l)
        linksOf[world.clusterLinks[l].particle].push_back(out.parameters.linkCount + l);
    const auto places = out.particleRanks.download();
    std::vector<gpu::uvec4> particles;
    std::vector<uint32_t> links;
    for (const SoftBody& soft : world.softBodies)
        for (uint32_t i = soft.particleStart; i < soft.particleStart + soft.particleCount; ++i) {
            particles.push_back({places[i].x, places[i].y, static_cast<uint32_t>(links.size()),
                                 static_cast<uint32_t>(linksOf[i].size())});
            links.insert(links.end(), linksOf[i].begin(), linksOf[i].end());
        }
    out.softParticles = {"softParticles", std::span<const gpu::uvec4>(particles)};
    out.softLinks = {"softLinks", std::span<const uint32_t>(links)};
    out.softImpulses = {"softImpulses", particles.size()};
    out.parameters.softCount = static_cast<uint32_t>(particles.size());
    if (!particles.empty()) out.hasParticleImpulses = true;
}

}  // namespace knuckle
