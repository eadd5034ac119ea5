#include "sim/world/matter/grain.h"

#include <algorithm>

#include "sim/world/world.h"

namespace knuckle {

namespace {

/// How much the two sizes differ from their mean [diameters].
constexpr float SPREAD = 0.12f;
/// Static friction between two grains over that of a mass of them.
constexpr float STICKING = 0.3f;

/// Kinetic friction between two grains of a mass of them with friction `mu`. What moves is braked by more than what
/// begins to move, so that a heap that was poured is as steep as one that is left; little friction by more than its
/// share, as a thin layer runs far.
float sliding(float mu)
{
    return std::min(mu, std::max(0.17f, 0.62f * mu));
}

}  // namespace

float grainScale(uint32_t k)
{
    uint32_t bits = k * 2654435761u;
    bits = (bits ^ bits >> 15) * 2246822519u;
    return (bits >> 13 & 1u) != 0 ? 1.0f + SPREAD : 1.0f - SPREAD;
}

float largestScale(const World& world)
{
    float largest = 1.0f;
    for (const Particle& particle : world.particles) largest = std::max(largest, particle.scale);
    return largest;
}

GrainFriction grainFriction(const Material& material)
{
    return {STICKING * (material.staticFriction + material.rollingFriction),
            sliding(material.kineticFriction + material.rollingFriction)};
}

}  // namespace knuckle
