#include "render/view/framed_sets.h"

#include <algorithm>
#include <utility>

#include "sim/base/errors.h"

namespace knuckle {

namespace {

/// The ranges as numbers that can be compared.
std::vector<std::pair<uint32_t, uint32_t>> numbersOf(const std::vector<ParticleRange>& ranges)
{
    std::vector<std::pair<uint32_t, uint32_t>> numbers;
    for (const ParticleRange& range : ranges) numbers.emplace_back(range.first, range.end);
    return numbers;
}

}  // namespace

FramedSets framedSets(const std::vector<Shot>& shots, const World& world)
{
    FramedSets sets;
    std::vector<std::vector<std::pair<uint32_t, uint32_t>>> known;
    const auto bitOf = [&](const std::vector<ParticleRange>& ranges) -> uint32_t {
        if (ranges.empty()) return 0;
        const auto numbers = numbersOf(ranges);
        const auto found = std::ranges::find(known, numbers);
        const auto set = static_cast<size_t>(found - known.begin());
        if (set == 32) throw InputError("shots: cameras frame more than 32 different choices of objects; use fewer");
        const uint32_t bit = 1u << set;
        if (found != known.end()) return bit;
        known.push_back(numbers);
        sets.words.resize(world.particles.size());
        for (const auto& [first, end] : numbers)
            for (uint32_t p = first; p < end; ++p) sets.words.at(p) |= bit;
        return bit;
    };
    for (const Shot& shot : shots) {
        const CameraSettings& camera = shot.camera;
        sets.bits.push_back(camera.attention == CameraAttention::None ? 0 : bitOf(camera.named));
        sets.sharp.push_back(bitOf(camera.focused));
    }
    return sets;
}

std::vector<Shot> shotsOf(const RenderSettings& settings)
{
    return settings.shots.empty() ? std::vector{Shot{.camera = settings.camera}} : settings.shots;
}

std::vector<Camera> camerasOf(const std::vector<Shot>& shots, const World& world, float aspect)
{
    std::vector<Camera> cameras;
    for (const Shot& shot : shots) cameras.emplace_back(shot.camera, world, aspect);
    return cameras;
}

std::vector<gpu::vec4> cameraPlanes(const World& world)
{
    std::vector<gpu::vec4> planes;
    for (uint32_t i = 0; i < world.colliders.size(); ++i) {
        const Collider& collider = world.colliders[i];
        if (collider.shape != ColliderShape::Plane || !collider.visible || moves(world, i)) continue;
        const Vector3f normal = collider.orientation * Vector3f::UnitY();
        planes.push_back({normal.x(), normal.y(), normal.z(), normal.dot(collider.position)});
    }
    return planes;
}

CameraSolids cameraSolids(const World& world)
{
    CameraSolids all;
    std::vector<uint32_t> first;
    for (const ColliderGrid& grid : world.colliderGrids) {
        first.push_back(static_cast<uint32_t>(all.grids.size()));
        all.grids.insert(all.grids.end(), grid.values.begin(), grid.values.end());
    }
    for (uint32_t i = 0; i < world.colliders.size(); ++i) {
        const Collider& c = world.colliders[i];
        if (c.shape == ColliderShape::Plane || !c.visible) continue;
        gpu::CameraSolid solid{};
        if (c.shape == ColliderShape::Box) solid.extents = {c.halfExtents.x(), c.halfExtents.y(), c.halfExtents.z(), 0};
        if (c.shape == ColliderShape::Sphere) solid.extents = {0, 0, 0, c.radius};
        if (c.shape == ColliderShape::Capsule) solid.extents = {0, c.halfHeight, 0, c.radius};
        solid.low.w = static_cast<float>(i);
        solid.cell = {1, 1, 1, static_cast<float>(c.shape)};
        if (c.grid != NO_INDEX) {
            const ColliderGrid& grid = world.colliderGrids[c.grid];
            const Eigen::Matrix<uint32_t, 3, 1> counts = grid.counts.cast<uint32_t>();
            solid.low = {grid.low.x(), grid.low.y(), grid.low.z(), solid.low.w};
            solid.cell = {grid.cell.x(), grid.cell.y(), grid.cell.z(), solid.cell.w};
            solid.grid = {counts.x(), counts.y(), counts.z(), first[c.grid]};
        }
        all.solids.push_back(solid);
    }
    return all;
}

}  // namespace knuckle
