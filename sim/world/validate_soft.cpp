#include <fmt/format.h>

#include <stdexcept>

#include "sim/base/errors.h"
#include "sim/world/world.h"

namespace knuckle {

namespace {

void requireWithin(const Material& material, const char* what, float value, float low, float high, const char* unit)
{
    if (value >= low && value <= high) return;
    throw std::logic_error(
        fmt::format("material \"{}\": {} {}{} must be {} to {}", material.name, what, value, unit, low, high));
}

void validateElasticity(const Material& material)
{
    const Elasticity& e = material.elasticity;
    requireWithin(material, "stiffness", e.stiffness, 1.0f, 1e12f, " Pa");
    requireWithin(material, "Poisson ratio", e.poissonRatio, 0.0f, 0.45f, "");
    requireWithin(material, "damping", e.damping, 0.0f, 1.0f, " s");
    requireWithin(material, "yield", e.yield, 0.0f, 10.0f, "");
    requireWithin(material, "creep", e.creep, 0.0f, 1000.0f, " 1/s");
    requireWithin(material, "largest deformation", e.maxDeformation, 0.0f, 2.0f, "");
}

void validatePins(const World& world)
{
    for (const Particle& particle : world.particles)
        if (particle.pinned && (particle.body != NO_INDEX || particle.bodyCount > 0))
            throw std::logic_error("a particle of a body is pinned; make the body fixed");
}

void validateBlock(const World& world, const SoftBody& soft, uint32_t index)
{
    const auto fail = [&](const char* what) {
        throw std::logic_error(fmt::format("soft body \"{}\": {}", soft.name, what));
    };
    if (soft.clusterStart + soft.clusterCount > world.clusters.size()) fail("its clusters reach beyond the array");
    for (uint32_t c = soft.clusterStart; c < soft.clusterStart + soft.clusterCount; ++c) {
        const Cluster& cluster = world.clusters[c];
        if (cluster.softBody != index || cluster.linkCount == 0) fail("its clusters are not one block");
        if (cluster.linkStart + cluster.linkCount > world.clusterLinks.size()) fail("its links reach beyond the array");
        for (uint32_t l = cluster.linkStart; l < cluster.linkStart + cluster.linkCount; ++l) {
            const Link& link = world.clusterLinks[l];
            const uint32_t place = link.particle - soft.particleStart;
            if (link.body != c || place >= soft.particleCount) fail("a link names another cluster or body");
            if (!(link.mass > 0.0f)) fail("a link has no mass");
        }
    }
}

}  // namespace

void validateSoftBodies(const World& world)
{
    for (const Material& material : world.materials) validateElasticity(material);
    validatePins(world);
    if (world.softBodies.empty()) return;
    if (world.settings.solver == SolverKind::Paper)
        throw InputError(fmt::format("soft body \"{}\": the paper's solver has none; use solver method impulse",
                                     world.softBodies[0].name));
    for (uint32_t b = 0; b < world.softBodies.size(); ++b) validateBlock(world, world.softBodies[b], b);
}

}  // namespace knuckle
