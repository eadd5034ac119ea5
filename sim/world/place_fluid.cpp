#include <algorithm>
#include <cmath>
#include <set>

#include "sim/world/builder.h"
#include "sim/world/cells.h"

namespace knuckle {

namespace {

/// Whether any of the particles in cells stands nearer than `distance`, a cell at most.
bool anyNear(const std::vector<Particle>& particles, const Cells& cells, const Vector3f& x, float distance)
{
    for (int k = 0; k < 27; ++k) {
        const auto* members = cells.around(cells.cellOf(x), k);
        if (!members) continue;
        for (uint32_t i : *members)
            if ((particles[i].position - x).squaredNorm() < distance * distance) return true;
    }
    return false;
}

/// How deep particles lie [m]: layers across `up` in which there are any, wherever they are.
float depthOf(const std::vector<Particle>& particles, const Vector3f& up, float spacing)
{
    std::set<int> layers;
    for (const Particle& p : particles) layers.insert(static_cast<int>(std::floor(p.position.dot(up) / spacing)));
    return spacing * static_cast<float>(layers.size());
}

/// Over the density [m2/s2].
float mostCohesion(const std::vector<Material>& materials, float spacing)
{
    float most = 0.0f;
    for (const Material& m : materials)
        if (m.fluid) most = std::max(most, cohesionPressure(m.surfaceTension, spacing) / m.density);
    return most;
}

}  // namespace

void WorldBuilder::placeFluid()
{
    Cells solids(world_.diameter());
    for (uint32_t i = 0; i < particleCount(); ++i) solids.add(world_.particles[i].position, i);
    const float apart = 0.45f * (world_.diameter() + world_.fluidSpacing);
    std::erase_if(fluid_, [&](const Particle& p) { return anyNear(world_.particles, solids, p.position, apart); });
    world_.particles.insert(world_.particles.end(), fluid_.begin(), fluid_.end());
    world_.fluidCount = fluidCount();
    Settings& settings = world_.settings;
    if (fluid_.empty() || !choosesSubsteps_) return;
    const float spacing = world_.fluidSpacing, depth = depthOf(fluid_, settings.gravity.normalized(), spacing);
    const float pressure = settings.gravity.norm() * depth + mostCohesion(world_.materials, spacing);
    settings.substeps = std::max(settings.substeps, automaticFluidSubsteps(spacing, pressure, settings.timeStep));
}

}  // namespace knuckle
