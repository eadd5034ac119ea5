#include "sim/solver/contact/collider_stage.h"

#include <fmt/format.h>

#include <algorithm>

#include "sim/solver/pack.h"
#include "sim/world/errors.h"

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

gpu::GpuCollider packCollider(const World& world, const Collider& c, const std::vector<uint32_t>& starts)
{
    const Vector3f size = c.shape == ColliderShape::Box ? c.halfExtents : Vector3f(c.radius, c.halfHeight, 0);
    gpu::GpuCollider collider{pack(c.position, static_cast<float>(c.shape)),
                              pack(c.orientation),
                              pack(size, 0),
                              {c.staticFriction, c.kineticFriction, 0, 0},
                              {},
                              {}};
    if (!hasGrid(c)) return collider;
    const ColliderGrid& grid = world.colliderGrids[c.grid];
    const Eigen::Vector3<uint32_t> counts = grid.counts.cast<uint32_t>();
    collider.size = pack(grid.cell, 0);
    collider.gridLow = pack(grid.low, 0);
    collider.grid = {counts.x(), counts.y(), counts.z(), starts[c.grid]};
    return collider;
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
    std::vector<gpu::GpuCollider> all;
    for (const Collider& c : world.colliders) all.push_back(packCollider(world, c, starts));
    for (const Collider& c : world.drains) all.push_back(packCollider(world, c, starts));
    for (const Release& release : world.releases) all.push_back(packCollider(world, release.region, starts));
    colliders = {"colliders", std::span<const gpu::GpuCollider>(all)};
    gridValues = {"gridValues", std::span<const float>(values)};
}

void ColliderStage::addBuffers(BufferTable& table)
{
    table.add(Lifetime::Constant, colliders, gridValues);
}

}  // namespace knuckle
