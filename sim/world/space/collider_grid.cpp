#include "sim/world/space/collider_grid.h"

#include <algorithm>
#include <cmath>

namespace knuckle {

using Eigen::Vector3f;
using Eigen::Vector3i;

namespace {

/// A position between grid values: indices of the lower ones, and the weight of the upper ones on each axis.
struct Between {
    Vector3i cell;
    Vector3f share;
};

Between between(const ColliderGrid& grid, const Vector3f& point)
{
    const Vector3f last = (grid.counts.array() - 1).cast<float>();
    const Vector3f place = (point - grid.low).cwiseQuotient(grid.cell).cwiseMax(0.0f).cwiseMin(last);
    const Vector3i cell = place.cast<int>().cwiseMin(grid.counts - Vector3i::Constant(2)).cwiseMax(0);
    return {cell, place - cell.cast<float>()};
}

float mix(float a, float b, float share)
{
    return a + share * (b - a);
}

}  // namespace

void ColliderGrid::findBounds()
{
    if (vertices.empty()) return;
    drawnLow = drawnHigh = vertices.front();
    for (const Vector3f& vertex : vertices) {
        drawnLow = drawnLow.cwiseMin(vertex);
        drawnHigh = drawnHigh.cwiseMax(vertex);
    }
}

float meshDistance(const ColliderGrid& grid, const Vector3f& point)
{
    const Vector3f high = grid.low + grid.cell.cwiseProduct((grid.counts.array() - 1).cast<float>().matrix());
    const Vector3f outside = point - point.cwiseMax(grid.low).cwiseMin(high);
    const Between at = between(grid, point);
    // Of a row along x: its value, and how it rises over the cell.
    const auto row = [&](int y, int z) {
        const float* value = &grid.values[grid.index(at.cell.x(), at.cell.y() + y, at.cell.z() + z)];
        return Eigen::Vector2f(mix(value[0], value[1], at.share.x()), value[1] - value[0]);
    };
    const std::array rows = {row(0, 0), row(1, 0), row(0, 1), row(1, 1)};
    const auto layer = [&](int z) {
        return Eigen::Vector2f(rows[2 * z] + at.share.y() * (rows[2 * z + 1] - rows[2 * z]));
    };
    const Eigen::Vector2f distance = layer(0) + at.share.z() * (layer(1) - layer(0));
    if (outside == Vector3f::Zero()) return distance.x();
    const Vector3f slope(distance.y(), mix(rows[1].x() - rows[0].x(), rows[3].x() - rows[2].x(), at.share.z()),
                         layer(1).x() - layer(0).x());
    return (outside + distance.x() * slope.stableNormalized()).norm();
}

float heightfieldDistance(const ColliderGrid& grid, const Vector3f& point)
{
    const Vector3f high = grid.low + grid.cell.cwiseProduct((grid.counts.array() - 1).cast<float>().matrix());
    Vector3f outside = point - point.cwiseMax(grid.low).cwiseMin(high);
    outside.y() = 0.0f;
    const Between at = between(grid, point);
    const float* near = &grid.values[grid.index(at.cell.x(), 0, at.cell.z())];
    const float* far = near + grid.counts.x();
    const float height = mix(mix(near[0], near[1], at.share.x()), mix(far[0], far[1], at.share.x()), at.share.z());
    const float above = point.y() - height;
    if (outside.squaredNorm() > 0.0f) return std::hypot(outside.norm(), std::max(above, 0.0f));
    const float slopeX = mix(near[1] - near[0], far[1] - far[0], at.share.z()) / grid.cell.x();
    const float slopeZ = mix(far[0] - near[0], far[1] - near[1], at.share.x()) / grid.cell.z();
    return above / std::sqrt(1.0f + slopeX * slopeX + slopeZ * slopeZ);
}

ColliderGrid makeHeightfield(const Eigen::Vector2f& size, int columns, int rows, std::vector<float> heights)
{
    ColliderGrid grid;
    grid.counts = {columns, 1, rows};
    grid.cell = {size.x() / static_cast<float>(columns - 1), 1.0f, size.y() / static_cast<float>(rows - 1)};
    grid.low = {-0.5f * size.x(), 0.0f, -0.5f * size.y()};
    grid.values = std::move(heights);
    for (int z = 0; z < rows; ++z)
        for (int x = 0; x < columns; ++x) {
            const Vector3f flat = grid.low + grid.cell.cwiseProduct(Vector3i(x, 0, z).cast<float>());
            grid.vertices.emplace_back(flat.x(), grid.values[grid.index(x, 0, z)], flat.z());
            if (x + 1 == columns || z + 1 == rows) continue;
            const auto corner = static_cast<uint32_t>(grid.index(x, 0, z));
            const uint32_t right = corner + 1, behind = corner + static_cast<uint32_t>(columns);
            grid.triangles.push_back({corner, behind, right});
            grid.triangles.push_back({right, behind, behind + 1});
        }
    grid.findBounds();
    return grid;
}

}  // namespace knuckle
