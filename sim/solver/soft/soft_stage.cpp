#include "sim/solver/soft/soft_stage.h"

#include <algorithm>

#include "sim/solver/layout/cluster_links.h"
#include "sim/solver/layout/soft_pace.h"
#include "sim/solver/pack.h"

namespace knuckle {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Lame's two parameters over the density, and values computed from them.
gpu::SoftMatter matterOf(const World& world, const SoftBody& soft, const SoftPace& pace)
{
    const Material& material = world.materials[soft.material];
    const Elasticity& e = material.elasticity;
    const float ratio = pace.stiffness / material.density, nu = e.poissonRatio;
    gpu::SoftMatter out{};
    out.shear = ratio / (1.0f + nu);
    out.dilation = ratio * nu / ((1.0f + nu) * (1.0f - 2.0f * nu));
    out.damping = pace.damping;
    out.yield = e.yield;
    out.creep = e.creep;
    out.maxDeformation = e.maxDeformation;
    out.steepest = static_cast<float>(pace.steepest);
    out.iterations = static_cast<float>(pace.iterations);
    const Chebyshev chebyshev(pace.iterations);
    out.leastEigenvalue = static_cast<float>(chebyshev.least);
    out.rootCosine = static_cast<float>(chebyshev.cosine);
    return out;
}

/// @param grip what holds a bend, over the shear modulus [1/m2].
void addMoments(std::vector<gpu::vec4>& out, const ClusterMoments& m, float grip)
{
    const Eigen::Matrix3f inverse = m.inverse.cast<float>(), empty = m.empty.cast<float>();
    out.push_back(pack(inverse.diagonal(), static_cast<float>(m.mass)));
    out.push_back({inverse(0, 1), inverse(0, 2), inverse(1, 2), grip});
    out.push_back(pack(empty.diagonal(), 0));
    out.push_back({empty(0, 1), empty(0, 2), empty(1, 2), 0});
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
        const SoftPace pace = softPace(world, soft);
        iterations_ = std::max(iterations_, pace.iterations);
        matter.push_back(matterOf(world, soft, pace));
        const uint32_t particles = paced_.empty() ? 0 : paced_.back().particles.end;
        paced_.push_back({pace.iterations,
                          {soft.clusterStart, soft.clusterStart + soft.clusterCount},
                          {particles, particles + soft.particleCount}});
        const float overShear = 1.0f + world.materials[soft.material].elasticity.poissonRatio;
        for (uint32_t c = soft.clusterStart; c < soft.clusterStart + soft.clusterCount; ++c) {
            const Cluster& cluster = world.clusters[c];
            infos.push_back(
                {cluster.linkStart + setup.layout.linkCount, cluster.linkCount, cluster.softBody, soft.assembly});
            const ClusterMoments m = knuckle::clusterMoments(world, cluster);
            addMoments(moments, m, overShear * static_cast<float>(m.bending));
            for (int column = 0; column < 3; ++column) rests.push_back(pack(Vector3f::Unit(column), 0));
        }
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
    softImpulses = {"softImpulses", 2 * particles.size()};
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
    const uint32_t all = std::max(iterations_, count);
    for (uint32_t k = all * iteration / count; k < all * (iteration + 1) / count; ++k) {
        // From the first body that takes part to the last.
        Paced from = paced_.front(), to = paced_.back();
        if (k > 0) {
            const auto isDue = [&](const Paced& p) { return k * p.iterations / all != (k - 1) * p.iterations / all; };
            const auto first = std::find_if(paced_.begin(), paced_.end(), isDue);
            if (first == paced_.end()) continue;
            from = *first;
            to = *std::find_if(paced_.rbegin(), paced_.rend(), isDue);
        }
        const Kernel &match = k == 0 ? matchFirst_ : match_, &pull = k == 0 ? pullFirst_ : pull_;
        glProgramUniform4ui(match.program(), 0, k, all, from.clusters.begin, to.clusters.end);
        glProgramUniform2ui(pull.program(), 0, from.particles.begin, to.particles.end);
        recorder.perElement(match, to.clusters.end - from.clusters.begin);
        recorder.perElement(pull, to.particles.end - from.particles.begin);
    }
}

}  // namespace knuckle
