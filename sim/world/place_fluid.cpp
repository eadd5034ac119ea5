#include <algorithm>
#include <cmath>
#include <map>

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

/// How many particles lie one above the other where they are deepest, as the mean of a square of four by four.
float layersOf(const std::vector<Particle>& fluid, float spacing)
{
    std::map<std::pair<int, int>, int> columns;
    int most = 0;
    for (const Particle& p : fluid) {
        const Vector3f place = p.position / (4.0f * spacing);
        most = std::max(most, ++columns[{static_cast<int>(std::floor(place.x())), static_cast<int>(std::floor(place.z()))}]);
    }
    return static_cast<float>(most) / 16.0f;
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
    const float layers = layersOf(fluid_, world_.fluidSpacing);
    settings.substeps = std::max(settings.substeps,
                                 automaticFluidSubsteps(world_.fluidSpacing, layers, settings.timeStep));
}

}  // namespace knuckle
