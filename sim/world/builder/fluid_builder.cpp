#include "sim/world/builder/fluid_builder.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>
#include <utility>

#include "sim/world/space/cells.h"

namespace knuckle {

float fluidClearance(const World& world)
{
    return 0.45f * (world.diameter() + world.fluidSpacing);
}

namespace {

/// Depth of the fluid [m]: the number of layers along `up` that hold particles, times their spacing.
float depthOf(const std::vector<Particle>& particles, const Vector3f& up, float spacing)
{
    std::set<int> layers;
    for (const Particle& p : particles) layers.insert(static_cast<int>(std::floor(p.position.dot(up) / spacing)));
    return spacing * static_cast<float>(layers.size());
}

/// Whether a fluid particle has room at x: no solid particle is nearer than `apart`, and they do not surround x like
/// the lattice of a body surrounds the middle of a cell.
bool hasRoom(const World& world, const Cells& solids, const Vector3f& x, float apart)
{
    const std::vector<uint32_t> near = solids.allNear(world.particles, x, 0.95f * world.diameter());
    Vector3f sum(0, 0, 0);
    for (uint32_t i : near) {
        const Vector3f away = world.particles[i].position - x;
        if (away.norm() < apart) return false;
        sum += away.normalized();
    }
    return near.size() < 4 || sum.norm() >= 0.35f * static_cast<float>(near.size());
}

/// The largest pressure from surface tension in any of the fluids, over its density [m2/s2].
float mostCohesion(const std::vector<Material>& materials, float spacing)
{
    float most = 0.0f;
    for (const Material& m : materials)
        if (m.fluid) most = std::max(most, cohesionPressure(m.surfaceTension, spacing) / m.density);
    return most;
}

}  // namespace

uint32_t World::pooledCount() const
{
    uint32_t count = 0;
    for (const Emitter& emitter : emitters) count += emitter.pool;
    return count;
}

void FluidBuilder::setFluidSpacing(float spacing)
{
    world_.fluidSpacing = spacing * world_.diameter();
}

void FluidBuilder::requireFluid(const char* what, uint32_t material) const
{
    if (material >= world_.materials.size() || !world_.materials[material].fluid)
        throw std::logic_error(fmt::format("{}(): material {} is not a fluid", what, material));
}

Particle FluidBuilder::fluidParticle(uint32_t material) const
{
    Particle particle;
    particle.material = material;
    particle.mass = world_.materials[material].density * std::pow(world_.fluidSpacing, 3.0f);
    return particle;
}

void FluidBuilder::addFluid(std::span<const Vector3f> positions, const Vector3f& velocity, uint32_t material,
                            std::string name, bool visible)
{
    const uint32_t first = fluidCount();
    fluidGroups_.push_back({std::move(name), first, first + static_cast<uint32_t>(positions.size()), visible});
    requireFluid("addFluid", material);
    Particle particle = fluidParticle(material);
    particle.velocity = velocity;
    for (const Vector3f& position : positions) {
        particle.position = particle.restPosition = position;
        fluid_.push_back(particle);
    }
}

void FluidBuilder::addEmitter(Emitter emitter)
{
    requireFluid("addEmitter", emitter.material);
    world_.emitters.push_back(std::move(emitter));
}

void FluidBuilder::placeFilled()
{
    Cells solids(world_.diameter());
    for (uint32_t i = 0; i < particleCount(); ++i) solids.add(world_.particles[i].position, i);
    const float apart = fluidClearance(world_);
    const uint32_t first = particleCount();
    std::vector<Particle> placed;
    for (LooseGroup group : fluidGroups_) {
        const std::span<const Particle> own(&fluid_[group.first], group.end - group.first);
        group.first = first + static_cast<uint32_t>(placed.size());
        for (const Particle& p : own)
            if (hasRoom(world_, solids, p.position, apart)) placed.push_back(p);
        group.end = first + static_cast<uint32_t>(placed.size());
        if (!group.visible) hideParticles(group.first, group.end);
        world_.looseGroups.push_back(std::move(group));
    }
    fluid_ = std::move(placed);
    world_.particles.insert(world_.particles.end(), fluid_.begin(), fluid_.end());
}

void FluidBuilder::placeFluid()
{
    placeFilled();
    for (const Emitter& emitter : world_.emitters) {
        Particle particle = fluidParticle(emitter.material);
        if (!emitter.nozzle.points.empty()) particle.position = emitter.nozzle.points.front();
        particle.restPosition = particle.position;
        world_.particles.insert(world_.particles.end(), emitter.pool, particle);
    }
    world_.fluidCount = fluidCount() + world_.pooledCount();
    Settings& settings = world_.settings;
    if (world_.fluidCount == 0) return;
    const float spacing = world_.fluidSpacing, depth = depthOf(fluid_, settings.gravity.normalized(), spacing);
    const float weight = settings.gravity.norm() * depth, cohesion = mostCohesion(world_.materials, spacing);
    const uint32_t needed = choosesSubsteps_ ? automaticFluidSubsteps(spacing, weight + cohesion, settings.timeStep)
                                             : leastFluidSubsteps(spacing, weight, settings.timeStep);
    settings.substeps = std::max(settings.substeps, needed);
}

}  // namespace knuckle
