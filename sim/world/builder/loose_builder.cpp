#include "sim/world/builder/loose_builder.h"

#include <utility>

namespace knuckle {

uint32_t LooseBuilder::addLooseParticle(const Particle& particle)
{
    world_.particles.push_back(particle);
    return particleCount() - 1;
}

void LooseBuilder::nameLoose(std::string name, uint32_t first)
{
    world_.looseGroups.push_back({std::move(name), first, particleCount()});
}

void LooseBuilder::addStrand(Strand row)
{
    world_.strands.push_back(std::move(row));
}

uint32_t LooseBuilder::addSoftBody(std::string name, std::span<const Vector3f> positions, uint32_t material,
                                   std::span<const uint32_t> pinned)
{
    requireObject("addSoftBody");
    SoftBody body;
    body.name = std::move(name);
    body.material = material;
    body.object = static_cast<uint32_t>(world_.objects.size() - 1);
    body.particleStart = particleCount();
    for (uint32_t particle : newParticles(body.name, positions, material))
        world_.particles[particle].selfMargin = SOFT_SELF_MARGIN;
    body.particleCount = particleCount() - body.particleStart;
    for (uint32_t index : pinned) world_.particles.at(body.particleStart + index).pinned = true;
    world_.softBodies.push_back(std::move(body));
    return static_cast<uint32_t>(world_.softBodies.size() - 1);
}

}  // namespace knuckle
