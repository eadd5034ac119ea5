#include "sim/world/builder/parts/substeps.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace knuckle {

namespace {

constexpr float MOST_SUBSTEPS = 64.0f;

/// The loose particles in which threads of cloth cross.
std::vector<bool> crossings(const World& world)
{
    std::vector<uint32_t> threads(world.particles.size());
    for (const Strand& row : world.strands)
        for (uint32_t p : row.particles) threads[p] += row.kind == DistanceKind::Stretch ? 1 : 0;
    std::vector<bool> out;
    for (size_t p = 0; p < threads.size(); ++p)
        out.push_back(threads[p] > 1 && !isFixedForEver(world, world.particles[p]));
    return out;
}

/// The highest speed at which something may hit the cloth of a world: its own, plus what it gains by falling to the
/// lowest point of the cloth [m/s]. 0 without cloth.
float clothImpactSpeed(const World& world)
{
    const Vector3f& gravity = world.settings.gravity;
    const std::vector<bool> cloth = crossings(world);
    float lowest = -std::numeric_limits<float>::infinity(), fastest = 0.0f;  // gravity times height below the origin
    for (uint32_t p = 0; p < world.solidCount(); ++p)
        if (cloth[p]) lowest = std::max(lowest, gravity.dot(world.particles[p].position));
    if (std::isinf(lowest)) return 0.0f;
    for (uint32_t p = 0; p < world.solidCount(); ++p) {
        const Particle& particle = world.particles[p];
        if (isFixedForEver(world, particle)) continue;
        const float fall = cloth[p] ? 0.0f : std::max(lowest - gravity.dot(particle.position), 0.0f);
        fastest = std::max(fastest, particle.velocity.squaredNorm() + 2.0f * fall);
    }
    return std::sqrt(fastest);
}

uint32_t wholeSubsteps(float needed)
{
    return static_cast<uint32_t>(std::min(std::ceil(needed - 0.01f), MOST_SUBSTEPS));
}

}  // namespace

uint32_t clothSubsteps(const World& world)
{
    return wholeSubsteps(5.0f * clothImpactSpeed(world) * world.settings.timeStep / world.diameter());
}

}  // namespace knuckle
