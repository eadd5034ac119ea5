#include "sim/solver/soft/soft_stage.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/solver/layout/cluster_links.h"
#include "sim/solver/pack.h"

namespace knuckle {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Lame's two parameters over the density, and values computed from them.
gpu::SoftMatter matterOf(const World& world, const SoftBody& soft)
{
    const Material& material = world.materials[soft.material];
    const Elasticity& e = material.elasticity;
    const float ratio = e.stiffness / material.density, nu = e.poissonRatio;
    gpu::SoftMatter out{};
    out.shear = ratio / (1.0f + nu);
    out.dilation = ratio * nu / ((1.0f + nu) * (1.0f - 2.0f * nu));
    out.damping = e.damping;
    out.yield = e.yield;
    out.creep = e.creep;
    out.maxDeformation = e.maxDeformation;
    return out;
}

/// The largest growth of a cluster's pull on a particle with its displacement, per mass [1/s2].
double steepness(const gpu::SoftMatter& matter, const ClusterMoments& moments)
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

/// The divisor of an iteration, in 0 ... 1, the largest first. They are the roots of the Chebyshev polynomial that
/// leaves at most MOST_LEFT of the error of any strain, however stiff. (In a plain Jacobi iteration all are 1, and
/// smooth strains converge slowly.)
float rootOf(uint32_t iteration, uint32_t count)
{
    constexpr float MOST_LEFT = 0.3f;
    const auto n = static_cast<float>(count);
    const float shift = std::cosh(std::acosh(1.0f / MOST_LEFT) / n);
    const float angle = std::numbers::pi_v<float> * (n - static_cast<float>(iteration) - 0.5f) / n;
    return (shift - std::cos(angle)) / (shift + 1.0f);
}

}  // namespace

bool SoftStage::isNeeded(const World& world)
{
    return world.settings.solver == SolverKind::Impulse && !world.clusters.empty();
}

SoftStage::SoftStage(const StageSetup& setup) : parameters_(setup.parameters) {}

void SoftStage::upload(const StageSetup& setup)
{
    uploadClusters(setup);
    uploadParticles(setup);
}

void SoftStage::uploadClusters(const StageSetup& setup)
{
    const World& world = setup.world;
    std::vector<gpu::Cluster> infos;
    std::vector<gpu::vec4> moments, rests, rotations;
    std::vector<gpu::SoftMatter> matter;
    for (const SoftBody& soft : world.softBodies) {
        matter.push_back(matterOf(world, soft));
        std::vector<double> steep(soft.particleCount);  // per particle, weighted by the clusters' fractions of its mass
        for (uint32_t c = soft.clusterStart; c < soft.clusterStart + soft.clusterCount; ++c) {
            const Cluster& cluster = world.clusters[c];
            infos.push_back(
                {cluster.linkStart + setup.layout.linkCount, cluster.linkCount, cluster.softBody, soft.assembly});
            const ClusterMoments m = knuckle::clusterMoments(world, cluster);
            addMoments(moments, m);
            for (int column = 0; column < 3; ++column) rests.push_back(pack(Vector3f::Unit(column), 0));
            for (uint32_t l = cluster.linkStart; l < cluster.linkStart + cluster.linkCount; ++l) {
                const Link& link = world.clusterLinks[l];
                steep[link.particle - soft.particleStart] += steepness(matter.back(), m) * link.mass /
                                                             world.particles[link.particle].mass;
            }
        }
        if (!steep.empty()) matter.back().steepest = static_cast<float>(*std::max_element(steep.begin(), steep.end()));
    }
    for (const Cluster& cluster : world.clusters) {
        const Quaternionf q = world.softBodies[cluster.softBody].rotation;
        rotations.push_back(pack(q));
    }
    clusterInfo = {"clusterInfo", std::span<const gpu::Cluster>(infos)};
    clusterMoments = {"clusterMoments", std::span<const gpu::vec4>(moments)};
    clusterRests = {"clusterRests", std::span<const gpu::vec4>(rests)};
    clusterRotations = {"clusterRotations", std::span<const gpu::vec4>(rotations)};
    softMatter = {"softMatter", std::span<const gpu::SoftMatter>(matter)};
    clusterPulls = {"clusterPulls", 5 * infos.size()};
    setup.parameters.clusterCount = static_cast<uint32_t>(infos.size());
}

void SoftStage::uploadParticles(const StageSetup& setup)
{
    const World& world = setup.world;
    std::vector<std::vector<uint32_t>> linksOf(world.particles.size());
    for (uint32_t l = 0; l < world.clusterLinks.size(); ++l)
        linksOf[world.clusterLinks[l].particle].push_back(setup.layout.linkCount + l);
    std::vector<gpu::uvec4> particles;
    std::vector<uint32_t> links;
    for (const SoftBody& soft : world.softBodies)
        for (uint32_t i = soft.particleStart; i < soft.particleStart + soft.particleCount; ++i) {
            const gpu::ParticleRank& rank = setup.layout.ranks[i];
            particles.push_back(
                {rank.mover, rank.rank, static_cast<uint32_t>(links.size()), static_cast<uint32_t>(linksOf[i].size())});
            links.insert(links.end(), linksOf[i].begin(), linksOf[i].end());
        }
    softParticles = {"softParticles", std::span<const gpu::uvec4>(particles)};
    softLinks = {"softLinks", std::span<const uint32_t>(links)};
    softImpulses = {"softImpulses", particles.size()};
    setup.parameters.softCount = static_cast<uint32_t>(particles.size());
}

void SoftStage::addBuffers(BufferTable& table)
{
    table.add(Lifetime::Constant, clusterInfo, clusterMoments, softParticles, softLinks);
    table.addFloatStructs(Lifetime::Constant, softMatter);
    table.add(Lifetime::State, clusterRotations, clusterRests);
    table.add(Lifetime::Scratch, clusterPulls, softImpulses);
}

void SoftStage::solve(Recorder& recorder, uint32_t iteration, uint32_t count) const
{
    const Kernel& pull = iteration == 0 ? pullFirst_ : pull_;
    glProgramUniform1f(pull.program(), 0, rootOf(iteration, count));
    recorder.perElement(iteration == 0 ? matchFirst_ : match_, parameters_.clusterCount);
    recorder.perElement(pull, parameters_.softCount);
}

}  // namespace knuckle
