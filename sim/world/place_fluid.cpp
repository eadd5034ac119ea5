#include <algorithm>

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
    settings.substeps = std::max(settings.substeps, automaticFluidSubsteps(world_.fluidSpacing, settings.timeStep));
}

}  // namespace knuckle
