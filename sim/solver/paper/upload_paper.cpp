#include "sim/solver/paper/upload_paper.h"

#include "sim/solver/pack.h"

namespace knuckle {

namespace {

/// A shared particle draws its bodies with one mass for all, so that momentum is kept: as much as brings them to the mean
/// of their goals in an iteration, split over the shared particles of each. In a body's match it counts with its own,
/// so it stands beyond the mean by so many times the distance.
std::vector<float> linkGains(const World& world, std::span<const gpu::ParticleRigidBodyLink> links,
                             std::span<const float> inverseMasses)
{
    std::vector<float> sharedOfBody(world.bodies.size()), inverse(world.particles.size());
    const auto isShared = [&](const gpu::ParticleRigidBodyLink& link) {
        return world.particles[link.particleIndex].bodyCount > 1;
    };
    for (const auto& link : links) sharedOfBody[link.rbIndex] += isShared(link) ? 1.0f : 0.0f;
    for (size_t l = 0; l < links.size(); ++l)
        if (isShared(links[l])) inverse[links[l].particleIndex] += inverseMasses[l] * sharedOfBody[links[l].rbIndex];
    std::vector<float> gains(links.size());
    for (size_t l = 0; l < links.size(); ++l) {
        const Particle& particle = world.particles[links[l].particleIndex];
        const float all = inverse[links[l].particleIndex];
        if (!isShared(links[l]) || all <= 0.0f) continue;
        const bool fixed = world.bodies[particle.body].motion == Motion::Fixed;
        const float mass = (fixed ? 1.0f : static_cast<float>(particle.bodyCount)) / all;
        gains[l] = mass / links[l].mass - 1.0f;
    }
    return gains;
}

/// Every second partial sum of a block takes in the next, then every fourth, and so on.
void makeReduction(SolverBuffers& out, const World& world)
{
    std::vector<uint32_t> all;
    for (uint32_t stride = 1;; stride *= 2) {
        const auto begin = static_cast<uint32_t>(all.size());
        for (const Body& body : world.bodies)
            for (uint32_t k = 0; k + stride < body.linkCount; k += 2 * stride) all.push_back(body.linkStart + k);
        const auto end = static_cast<uint32_t>(all.size());
        if (begin == end) break;
        out.reductionSteps.push_back({begin, end, stride});
    }
    out.reductionLinks = {"reductionLinks", std::span<const uint32_t>(all)};
}

}  // namespace

void setPaperParameters(gpu::StepParameters& p, const World& world)
{
    p.overRelaxation = 2.0f;
    p.maxCorrection = 50.0f * 9.81f * p.substepTime * p.substepTime;
    p.stabilization = 0.5f * p.substepTime;
    p.deepOverlap = 0.2f * world.diameter();
    p.deepRecovery = 0.75f * p.substepTime;
    p.jointCorrection = 4.0f * p.substepTime;
}

void makePaper(SolverBuffers& out, const World& world, std::span<const gpu::ParticleRigidBodyLink> links,
               std::span<const float> inverseMasses)
{
    std::vector<gpu::vec4> velocities;
    for (const Particle& p : world.particles) velocities.push_back(pack(p.velocity, 0));
    const size_t count = world.particles.size();
    out.oldMoves = {"oldMoves", count};
    out.oldVelocities = {"oldVelocities", std::span<const gpu::vec4>(velocities)};
    out.predicted = {"predicted", count};
    out.moved = {"moved", count};
    out.bodyStarts = {"bodyStarts", 2 * world.bodies.size()};
    out.bodyMatrices = {"bodyMatrices", 3 * world.bodies.size()};
    out.bodyActing = {"bodyActing", world.bodies.size()};
    out.linkTerms = {"linkTerms", 3 * world.links.size()};
    out.linkPulls = {"linkPulls", world.links.size()};
    makeReduction(out, world);
    const std::vector<float> gains = linkGains(world, links.first(world.links.size()), inverseMasses);
    out.linkGains = {"linkGains", std::span<const float>(gains)};
}

}  // namespace knuckle
