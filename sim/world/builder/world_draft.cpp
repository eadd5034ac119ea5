#include "sim/world/builder/world_draft.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>
#include <utility>

namespace knuckle {

WorldDraft::WorldDraft(float particleRadius, const Settings& settings)
{
    if (!(particleRadius > 0.0f) || !std::isfinite(particleRadius))  // before anything is divided by it
        throw std::logic_error(fmt::format("particle radius {} m: must be above 0", particleRadius));
    world_.particleRadius = particleRadius;
    world_.settings = settings;
    world_.fluidSpacing = 0.5f * world_.diameter();
    choosesSubsteps_ = settings.substeps == 0;
    if (choosesSubsteps_)
        world_.settings.substeps = automaticSubsteps(world_.diameter(), settings.timeStep, settings.solver);
}

uint32_t WorldDraft::addMaterial(Material material)
{
    world_.materials.push_back(std::move(material));
    return static_cast<uint32_t>(world_.materials.size() - 1);
}

void WorldDraft::requireObject(const char* what) const
{
    if (!objectOpen_) throw std::logic_error(fmt::format("{}: call beginObject() first", what));
}

uint32_t WorldDraft::newParticle(const Vector3f& position, uint32_t material)
{
    Particle particle;
    particle.position = particle.restPosition = position;
    particle.material = material;
    particle.mass = particleMass(material);
    world_.particles.push_back(particle);
    return particleCount() - 1;
}

float WorldDraft::particleMass(uint32_t material) const
{
    return world_.materials.at(material).density * std::pow(world_.diameter(), 3.0f);
}

std::vector<uint32_t> WorldDraft::newParticles(const std::string& name, std::span<const Vector3f> positions,
                                               uint32_t material)
{
    if (material >= world_.materials.size())
        throw std::logic_error(fmt::format("body \"{}\": there is no material {}", name, material));
    if (positions.empty()) throw std::logic_error(fmt::format("body \"{}\" has no particles", name));
    std::vector<uint32_t> indices;
    for (const Vector3f& position : positions) {
        if (!position.allFinite())
            throw std::logic_error(fmt::format("body \"{}\": a particle's position is not finite", name));
        indices.push_back(newParticle(position, material));
    }
    return indices;
}

}  // namespace knuckle
