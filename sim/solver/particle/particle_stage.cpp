#include "sim/solver/particle/particle_stage.h"

#include <algorithm>

#include "sim/solver/pack.h"

namespace knuckle {

namespace {

constexpr float NO_SELF_CONTACT = 1e9f;          // a margin [diameters] that nothing is beyond


/// Per particle: where its body's lattice ends. Bodies with joints are not flat (docs/trials.md), nor is any in
/// the paper's solver.
std::vector<uint32_t> latticeEndsOf(const World& world)
{
    const bool flat = world.settings.solver == SolverKind::Impulse;
    std::vector<uint32_t> bodies(world.assemblyCount), ends;
    for (const Body& body : world.bodies) ++bodies[body.assembly];
    for (const Particle& p : world.particles)
        ends.push_back(flat && p.bodyCount == 1 && bodies[p.assembly] == 1 ? p.surface.ends : ALL_ENDS);
    return ends;
}

/// Marks the particles of balls and capsules. Of those at the same place along the centre line, one stands for all at
/// colliders.
void markRounds(const World& world, std::vector<uint32_t>& ends)
{
    const float same = 1e-3f * world.diameter();
    for (const Body& body : world.bodies) {
        if (!body.round.exists()) continue;
        std::vector<float> places;
        for (uint32_t l = body.linkStart; l < body.linkStart + body.linkCount; ++l) {
            const float y = world.links[l].restOffset.y() + body.restCentre.y(), half = body.round.halfHeight;
            const float place = std::clamp(y, -half, half);
            const bool first = std::ranges::none_of(places, [&](float p) { return std::abs(p - place) < same; });
            ends[world.links[l].particle] = ALL_ENDS | IN_ROUND | (first ? CARRIES_ROUND : 0u);
            if (first) places.push_back(place);
        }
    }
}

}  // namespace

ParticleStage::ParticleStage(const StageSetup& setup)
{
    const World& world = setup.world;
    std::vector<gpu::vec4> places, speeds;
    const size_t firstPooled = world.particles.size() - world.pooledCount();
    for (const Particle& p : world.particles) {
        places.push_back(pack(p.position, places.size() >= firstPooled ? 1.0f : 0.0f));
        speeds.push_back(pack(isFixed(world, p) ? Vector3f::Zero() : p.velocity, 0));
    }
    positions = {"positions", std::span<const gpu::vec4>(places)};
    velocities = {"velocities", std::span<const gpu::vec4>(speeds)};
    uploadConstants(setup);
    uploadRestOffsets(setup);
    const std::vector<gpu::uvec2> untouched(setup.layout.assemblyCount, gpu::uvec2{NO_SUBSTEP, 1u});
    assemblyState = {"assemblyState", std::span<const gpu::uvec2>(untouched)};
}

void ParticleStage::uploadConstants(const StageSetup& setup)
{
    const World& world = setup.world;
    std::vector<gpu::vec4> rest, mass, surfaces;
    std::vector<gpu::ParticleInfo> infos;
    for (const Particle& p : world.particles) {
        const Material& material = world.materials[p.material];
        surfaces.push_back(p.bodyCount == 1 ? pack(p.surface.outward, p.surface.distance) : gpu::vec4{});
        rest.push_back(pack(p.restPosition, p.touchesAssembly ? p.selfMargin : NO_SELF_CONTACT));
        infos.push_back(
            {material.fluid ? IN_FLUID : p.body, p.bodyCount, setup.layout.assemblies[infos.size()], p.material});
        mass.push_back({1.0f / p.mass, material.restitution, material.staticFriction, material.kineticFriction});
    }
    std::vector<gpu::uvec2> ranks;
    for (const gpu::ParticleRank& rank : setup.layout.ranks) ranks.push_back({rank.mover, rank.rank});
    std::vector<uint32_t> ends = latticeEndsOf(world);
    hasFlatFaces = std::ranges::any_of(ends, [](uint32_t end) { return end != ALL_ENDS; });
    markRounds(world, ends);
    hasRounds = std::ranges::any_of(world.bodies, [](const Body& body) { return body.round.exists(); });
    restPositions = {"restPositions", std::span<const gpu::vec4>(rest)};
    masses = {"masses", std::span<const gpu::vec4>(mass)};
    particleSurfaces = {"particleSurfaces", std::span<const gpu::vec4>(surfaces)};
    particleInfo = {"particleInfo", std::span<const gpu::ParticleInfo>(infos)};
    particleRanks = {"particleRanks", std::span<const gpu::uvec2>(ranks)};
    rankedParticles = {"rankedParticles", std::span<const uint32_t>(setup.layout.rankedParticles)};
    latticeEnds = {"latticeEnds", std::span<const uint32_t>(ends)};
}

void ParticleStage::uploadRestOffsets(const StageSetup& setup)
{
    const World& world = setup.world;
    const std::vector<float>& worst = setup.layout.worstInverseMasses;
    std::vector<gpu::vec4> offsets(world.particles.size());
    for (size_t l = 0; l < world.links.size(); ++l) {
        const Link& link = world.links[l];
        if (world.particles[link.particle].body == link.body) offsets[link.particle] = pack(link.restOffset, worst[l]);
    }
    for (size_t i = 0; i < world.particles.size(); ++i)
        if (world.particles[i].body == NO_INDEX) offsets[i].w = 1.0f / world.particles[i].mass;
    restOffsets = {"restOffsets", std::span<const gpu::vec4>(offsets)};
}

void ParticleStage::addBuffers(BufferTable& table)
{
    table.add(positions, velocities, particleInfo, particleRanks, rankedParticles, masses, restPositions, restOffsets,
              particleSurfaces, latticeEnds, assemblyState);
}

}  // namespace knuckle
