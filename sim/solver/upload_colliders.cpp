#include "sim/solver/upload_colliders.h"

#include <fmt/format.h>

#include "sim/solver/pack.h"
#include "sim/world/errors.h"

namespace knuckle {

namespace {

bool hasGrid(const Collider& collider)
{
    return collider.shape == ColliderShape::Mesh || collider.shape == ColliderShape::Heightfield;
}

/// The values of all grids one after another. @returns where each begins.
std::vector<uint32_t> uploadGrids(const Gpu& gpu, SolverBuffers& out, const World& world)
{
    std::vector<uint32_t> firsts;
    std::vector<float> values;
    for (const ColliderGrid& grid : world.colliderGrids) {
        firsts.push_back(static_cast<uint32_t>(values.size()));
        values.insert(values.end(), grid.values.begin(), grid.values.end());
    }
    const auto limit = static_cast<uint64_t>(gpu.limits().textureBufferSize);
    if (values.size() > limit)
        throw DeviceError(fmt::format("{}: the colliders' grids have {} values and the device allows {}; raise the "
                                      "cells of mesh colliders, or use fewer", gpu.device().name, values.size(), limit));
    out.gridValues = {"gridValues", std::span<const float>(values)};
    return firsts;
}

}  // namespace

void uploadColliders(const Gpu& gpu, SolverBuffers& out, const World& world)
{
    const std::vector<uint32_t> firsts = uploadGrids(gpu, out, world);
    std::vector<gpu::GpuCollider> colliders;
    // Drains stand behind the colliders, where only fluid_drain looks.
    std::vector<Collider> all = world.colliders;
    all.insert(all.end(), world.drains.begin(), world.drains.end());
    for (const Collider& c : all) {
        const Vector3f size = c.shape == ColliderShape::Box ? c.halfExtents : Vector3f(c.radius, c.halfHeight, 0);
        gpu::GpuCollider collider{pack(c.position, static_cast<float>(c.shape)),
                                  pack(c.orientation.vec(), c.orientation.w()), pack(size, 0),
                                  {c.staticFriction, c.kineticFriction, 0, 0}, {}, {}};
        if (hasGrid(c)) {
            const ColliderGrid& grid = world.colliderGrids[c.grid];
            const Eigen::Vector3<uint32_t> counts = grid.counts.cast<uint32_t>();
            collider.size = pack(grid.cell, 0);
            collider.gridLow = pack(grid.low, 0);
            collider.grid = {counts.x(), counts.y(), counts.z(), firsts[c.grid]};
            out.hasGrids = true;
        }
        colliders.push_back(collider);
    }
    out.colliders = {"colliders", std::span<const gpu::GpuCollider>(colliders)};
}

}  // namespace knuckle
