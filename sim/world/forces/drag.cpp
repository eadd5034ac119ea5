#include <array>
#include <cmath>
#include <numbers>
#include <set>
#include <utility>
#include <vector>

#include "shared/force_types.h"
#include "sim/world/forces/forces.h"
#include "sim/world/world.h"

namespace knuckle {

namespace {

using Cell = std::array<int, 3>;

float airDensity(const World& world)
{
    return world.wind ? world.wind->density : 0.0f;
}

Cell cellAt(const Vector3f& offset, float diameter)
{
    const Vector3f place = (offset / diameter).array().round();
    return {static_cast<int>(place.x()), static_cast<int>(place.y()), static_cast<int>(place.z())};
}

/// The area that particles cover, seen along each axis [m2]. @param offsets in the body at rest [m].
Vector3f silhouette(const std::vector<Vector3f>& offsets, float diameter)
{
    Vector3f areas;
    for (size_t axis = 0; axis < 3; ++axis) {
        std::set<std::pair<int, int>> columns;
        for (const Vector3f& offset : offsets) {
            const Cell cell = cellAt(offset - offsets.front(), diameter);
            columns.insert({cell[(axis + 1) % 3], cell[(axis + 2) % 3]});
        }
        areas[static_cast<Eigen::Index>(axis)] = static_cast<float>(columns.size()) * diameter * diameter;
    }
    return areas;
}

Vector3f dragOf(const World& world, const Body& body)
{
    double mass = 0.0;
    std::vector<Vector3f> offsets;
    for (uint32_t l = body.linkStart; l < body.linkStart + body.linkCount; ++l) {
        mass += world.links[l].mass;
        offsets.push_back(world.links[l].restOffset);
    }
    const float half = 0.5f * airDensity(world) / static_cast<float>(mass);
    if (!(body.round.radius > 0.0f)) return half * float(BLOCK_DRAG) * silhouette(offsets, world.diameter());
    const float r = body.round.radius, end = std::numbers::pi_v<float> * r * r, side = 4.0f * r * body.round.halfHeight;
    return half * float(SPHERE_DRAG) * Vector3f(end + side, end, end + side);
}

/// Gives each particle of a soft body its share of the surface, by how many of its six sides have no neighbour.
void addSoft(const World& world, const SoftBody& soft, std::vector<float>& areas)
{
    std::set<Cell> cells;
    const Vector3f& first = world.particles[soft.particleStart].restPosition;
    const auto cellOf = [&](uint32_t p) { return cellAt(world.particles[p].restPosition - first, world.diameter()); };
    for (uint32_t p = soft.particleStart; p < soft.particleStart + soft.particleCount; ++p) cells.insert(cellOf(p));
    for (uint32_t p = soft.particleStart; p < soft.particleStart + soft.particleCount; ++p) {
        int open = 0;
        for (size_t axis = 0; axis < 3; ++axis)
            for (const int step : {-1, 1}) {
                Cell beside = cellOf(p);
                beside[axis] += step;
                open += cells.contains(beside) ? 0 : 1;
            }
        // Averaged over all directions, a body covers a quarter of its surface (Cauchy).
        areas[p] = 0.25f * static_cast<float>(open) * float(BLOCK_DRAG) * world.diameter() * world.diameter();
    }
}

/// Per particle, drag coefficient times area [m2].
std::vector<float> looseAreas(const World& world)
{
    const float d = world.diameter();
    std::vector<float> areas(world.particles.size(), float(SPHERE_DRAG) * 0.25f * std::numbers::pi_v<float> * d * d);
    for (const Strand& strand : world.strands)
        for (const uint32_t p : strand.particles) areas[p] = float(ROPE_DRAG) * d * d;
    for (const std::array<uint32_t, 3>& triangle : world.clothTriangles)
        for (const uint32_t p : triangle) areas[p] = 0.0f;
    for (const SoftBody& soft : world.softBodies) addSoft(world, soft, areas);
    return areas;
}

}  // namespace

bool hasForces(const World& world)
{
    return world.wind || !world.forceFields.empty();
}

std::vector<Vector3f> dragsOf(const World& world)
{
    std::vector<Vector3f> drags;
    for (const Body& body : world.bodies) drags.push_back(dragOf(world, body));
    const std::vector<float> areas = looseAreas(world);
    for (uint32_t i = 0; i < world.solidCount(); ++i) {
        const Particle& particle = world.particles[i];
        if (particle.body != NO_INDEX) continue;
        drags.push_back(Vector3f::Constant(0.5f * airDensity(world) * areas[i] / particle.mass));
    }
    return drags;
}

}  // namespace knuckle
