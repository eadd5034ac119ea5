#include "sim/solver/particle/particle_stage.h"

#include <algorithm>

#include "sim/solver/pack.h"

namespace knuckle {

namespace {

constexpr float NO_SELF_CONTACT = 1e9f;  // a margin [diameters] that is always large enough

}  // namespace

void ParticleStage::upload(const StageSetup& setup)
{
    const World& world = setup.world;
    std::vector<gpu::vec4> places, speeds;
    const size_t firstPooled = world.particles.size() - world.pooledCount();
    for (const Particle& p : world.particles) {
        const bool absent = p.body != NO_INDEX && world.bodies[p.body].absent;
        const Vector3f away = absent ? awayFrom(world, world.bodies[p.body]) : Vector3f::Zero();
        places.push_back(pack(p.position + away, absent || places.size() >= firstPooled ? 1.0f : 0.0f));
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
    std::vector<gpu::Particle> infos;
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
    restPositions = {"restPositions", std::span<const gpu::vec4>(rest)};
    masses = {"masses", std::span<const gpu::vec4>(mass)};
    particleSurfaces = {"particleSurfaces", std::span<const gpu::vec4>(surfaces)};
    particleInfo = {"particleInfo", std::span<const gpu::Particle>(infos)};
    particleRanks = {"particleRanks", std::span<const gpu::uvec2>(ranks)};
    rankedParticles = {"rankedParticles", std::span<const uint32_t>(setup.layout.rankedParticles)};
    latticeEnds = {"latticeEnds", std::span<const uint32_t>(setup.layout.latticeEnds)};
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
    table.add(Lifetime::Constant, particleInfo, particleRanks, rankedParticles, masses, restPositions, restOffsets,
              particleSurfaces, latticeEnds);
    table.add(Lifetime::State, positions, velocities, assemblyState);
}

}  // namespace knuckle
