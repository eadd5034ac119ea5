#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/world/builder.h"
#include "sim/world/cells.h"
#include "sim/world/errors.h"

namespace knuckle {

float fluidClearance(const World& world)
{
    return 0.45f * (world.diameter() + world.fluidSpacing);
}

uint32_t World::pooledCount() const
{
    uint32_t count = 0;
    for (const Emitter& emitter : emitters) count += emitter.pool;
    return count;
}

void WorldBuilder::requireFluid(const char* what, uint32_t material) const
{
    if (material >= world_.materials.size() || !world_.materials[material].fluid)
        throw InputError(fmt::format("{}(): material {} is not a fluid", what, material));
}

Particle WorldBuilder::fluidParticle(uint32_t material) const
{
    Particle particle;
    particle.material = material;
    particle.mass = world_.materials[material].density * std::pow(world_.fluidSpacing, 3.0f);
    return particle;
}

void WorldBuilder::addFluid(std::span<const Vector3f> positions, const Vector3f& velocity, uint32_t material)
{
    requireFluid("addFluid", material);
    Particle particle = fluidParticle(material);
    particle.velocity = velocity;
    for (const Vector3f& position : positions) {
        particle.position = particle.restPosition = position;
        fluid_.push_back(particle);
    }
}

void WorldBuilder::addEmitter(Emitter emitter)
{
    requireFluid("addEmitter", emitter.material);
    world_.emitters.push_back(std::move(emitter));
}

void WorldBuilder::placeFluid()
{
    Cells solids(world_.diameter());
    for (uint32_t i = 0; i < particleCount(); ++i) solids.add(world_.particles[i].position, i);
    const float apart = fluidClearance(world_);
    std::erase_if(fluid_, [&](const Particle& p) {
        return solids.anyNear(world_.particles, p.position, apart).has_value();
    });
    world_.particles.insert(world_.particles.end(), fluid_.begin(), fluid_.end());
    for (const Emitter& emitter : world_.emitters) {
        Particle particle = fluidParticle(emitter.material);
        if (!emitter.nozzle.points.empty()) particle.position = emitter.nozzle.points.front();
        particle.restPosition = particle.position;
        world_.particles.insert(world_.particles.end(), emitter.pool, particle);
    }
    world_.fluidCount = fluidCount() + world_.pooledCount();
    Settings& settings = world_.settings;
    if (world_.fluidCount == 0 || !choosesSubsteps_) return;
    settings.substeps = std::max(settings.substeps, automaticFluidSubsteps(world_.fluidSpacing, settings.timeStep));
}

}  // namespace knuckle
