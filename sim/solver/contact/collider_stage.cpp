#include "sim/solver/contact/collider_stage.h"

#include <fmt/format.h>

#include <algorithm>

#include "sim/base/errors.h"
#include "sim/solver/pack.h"

namespace knuckle {

namespace {

bool hasGrid(const Collider& collider)
{
    return collider.shape == ColliderShape::Mesh || collider.shape == ColliderShape::Heightfield;
}

/// Where the values of each grid begin, one after another.
std::vector<uint32_t> gridStarts(const World& world)
{
    std::vector<uint32_t> starts{0};
    for (const ColliderGrid& grid : world.colliderGrids)
        starts.push_back(starts.back() + static_cast<uint32_t>(grid.values.size()));
    return starts;
}

gpu::Collider packCollider(const World& world, const Collider& c, const std::vector<uint32_t>& starts)
{
    const auto shape = static_cast<float>(c.shape);
    gpu::Collider collider{pack(sizeOf(c), shape), {c.staticFriction, c.kineticFriction, 0, 0}, {}, {}};
    if (!hasGrid(c)) return collider;
    const ColliderGrid& grid = world.colliderGrids[c.grid];
    const Eigen::Vector3<uint32_t> counts = grid.counts.cast<uint32_t>();
    collider.size = pack(grid.cell, shape);
    collider.gridLow = pack(grid.low, 0);
    collider.grid = {counts.x(), counts.y(), counts.z(), starts[c.grid]};
    return collider;
}

/// Whether it is a plane at rest where an earlier one is, as the floor of a container on the ground.
bool repeatsPlane(const World& world, size_t index)
{
    const Collider& plane = world.colliders[index];
    if (plane.shape != ColliderShape::Plane || moves(world, index)) return false;
    const Vector3f up = plane.orientation * Vector3f::UnitY();
    for (size_t k = 0; k < index; ++k) {
        const Collider& other = world.colliders[k];
        if (other.shape != ColliderShape::Plane || moves(world, k)) continue;
        const float apart = up.dot(other.position - plane.position);
        if (apart == 0.0f && up == other.orientation * Vector3f::UnitY()) return true;
    }
    return false;
}

}  // namespace

void ColliderStage::upload(const StageSetup& setup)
{
    const World& world = setup.world;
    const std::vector<uint32_t> starts = gridStarts(world);
    const auto limit = static_cast<uint64_t>(setup.gpu.limits().textureBufferSize);
    if (starts.back() > limit)
        throw DeviceError(fmt::format("{}: the colliders' grids have {} values and the device allows {}; raise the "
                                      "cells of mesh colliders, or use fewer",
                                      setup.gpu.device().name, starts.back(), limit));
    std::vector<float> values;
    for (const ColliderGrid& grid : world.colliderGrids)
        values.insert(values.end(), grid.values.begin(), grid.values.end());
    std::vector<gpu::Collider> all;
    std::vector<gpu::vec4> places;
    const auto add = [&](const Collider& c) {
        all.push_back(packCollider(world, c, starts));
        places.push_back(pack(c.position, 0));
        places.push_back(pack(c.orientation));
    };
    for (size_t c = 0; c < world.colliders.size(); ++c) {
        add(world.colliders[c]);
        all.back().friction.z = repeatsPlane(world, c) ? 1.0f : 0.0f;
    }
    const auto addRegion = [&](const Region& region) { add({region}); };
    for (const Region& drain : world.drains) addRegion(drain);
    for (const Release& release : world.releases) addRegion(release.region);
    colliders = {"colliders", std::span<const gpu::Collider>(all)};
    colliderPlaces = {"colliderPlaces", std::span<const gpu::vec4>(places)};
    gridValues = {"gridValues", std::span<const float>(values)};
    std::vector<gpu::vec4> still;
    for (size_t c = 0; c < (world.colliderMotions.empty() ? 0 : world.colliders.size()); ++c)
        still.insert(still.end(), {{0, 0, 0, 0}, {0, 0, 0, 1}});
    colliderMoves = {"colliderMoves", std::span<const gpu::vec4>(still)};
    colliderAheads = {"colliderAheads", still.size() / 2};
    colliderAheads.clear();
}

void ColliderStage::addBuffers(BufferTable& table)
{
    table.add(Lifetime::Constant, colliders, gridValues);
    table.add(Lifetime::State, colliderPlaces, colliderMoves, colliderAheads);
}

}  // namespace knuckle
