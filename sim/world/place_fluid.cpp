#include <algorithm>
#include <array>
#include <map>

#include "sim/world/builder.h"

namespace knuckle {

namespace {

/// Particles by cells of one diameter.
class Places {
public:
    Places(const std::vector<Particle>& particles, float size) : inverseSize_(1.0f / size)
    {
        for (const Particle& p : particles) cells_[cellOf(p.position)].push_back(p.position);
    }
    /// Whether any stands nearer than `distance`, a cell at most.
    bool near(const Vector3f& x, float distance) const
    {
        const auto middle = cellOf(x);
        for (int k = 0; k < 27; ++k) {
            const auto cell = cells_.find({middle[0] + k % 3 - 1, middle[1] + k / 3 % 3 - 1, middle[2] + k / 9 - 1});
            if (cell == cells_.end()) continue;
            for (const Vector3f& place : cell->second)
                if ((place - x).squaredNorm() < distance * distance) return true;
        }
        return false;
    }

private:
    std::array<int, 3> cellOf(const Vector3f& x) const
    {
        const Eigen::Vector3i c = (x * inverseSize_).array().floor().cast<int>();
        return {c.x(), c.y(), c.z()};
    }
    float inverseSize_;
    std::map<std::array<int, 3>, std::vector<Vector3f>> cells_;
};

}  // namespace

void WorldBuilder::placeFluid()
{
    const Places solids(world_.particles, world_.diameter());
    const float apart = 0.45f * (world_.diameter() + world_.fluidSpacing);
    std::erase_if(fluid_, [&](const Particle& p) { return solids.near(p.position, apart); });
    world_.particles.insert(world_.particles.end(), fluid_.begin(), fluid_.end());
    world_.fluidCount = fluidCount();
    Settings& settings = world_.settings;
    if (fluid_.empty() || !choosesSubsteps_) return;
    settings.substeps = std::max(settings.substeps, automaticFluidSubsteps(world_.fluidSpacing, settings.timeStep));
}

}  // namespace knuckle
