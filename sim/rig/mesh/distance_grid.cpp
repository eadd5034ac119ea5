#include "sim/rig/mesh/distance_grid.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/base/errors.h"

namespace knuckle {

using Eigen::Vector3f;

namespace {

constexpr float ROOM = 2.0f;  // cells around the mesh

void placeGrid(ColliderGrid& grid, float cell)
{
    const Vector3f size = grid.drawnHigh - grid.drawnLow;
    const Eigen::Vector3d counts = (size / cell).cast<double>().array().ceil() + (2.0 * ROOM + 1.0);
    if (!(counts.prod() <= static_cast<double>(MAX_GRID_VALUES))) {
        const double enough = cell * std::cbrt(counts.prod() / static_cast<double>(MAX_GRID_VALUES));
        throw InputError(
            fmt::format("cells of {:g} m need {:.3g} of them for a mesh of {:.3g} x {:.3g} x {:.3g} m, the "
                        "limit is {}; raise `cell` to {:.2g} or more",
                        cell, counts.prod(), size.x(), size.y(), size.z(), MAX_GRID_VALUES, 1.1 * enough));
    }
    grid.counts = counts.cast<int>();
    grid.cell = Vector3f::Constant(cell);
    const Vector3f reach = 0.5f * cell * (grid.counts.array() - 1).cast<float>();
    grid.low = 0.5f * (grid.drawnLow + grid.drawnHigh) - reach;
}

/// @returns whether any value is inside.
bool fillGrid(ColliderGrid& grid, const TriangleTree& tree)
{
    bool anyInside = false, inside = false;
    float before = 0.0f;  // distance of the value before on the row
    grid.values.reserve(grid.counts.cast<size_t>().prod());
    for (int z = 0; z < grid.counts.z(); ++z)
        for (int y = 0; y < grid.counts.y(); ++y)
            for (int x = 0; x < grid.counts.x(); ++x) {
                const Vector3f point = grid.low + grid.cell.cwiseProduct(Eigen::Vector3i(x, y, z).cast<float>());
                const float distance = tree.nearest(point).distance;
                // If one of two neighbours is further than a cell from the surface, no triangle lies between them and
                // both are on the same side. 1.5 cells, since a point on the surface itself has no certain side.
                if (x == 0 || std::max(before, distance) <= 1.5f * grid.cell.x()) inside = tree.inside(point);
                grid.values.push_back(inside ? -distance : distance);
                anyInside |= inside;
                before = distance;
            }
    return anyInside;
}

}  // namespace

ColliderGrid makeDistanceGrid(std::span<const Vector3f> vertices, std::span<const Triangle> triangles, float cell)
{
    if (triangles.empty()) throw InputError("the model has no triangles");
    ColliderGrid grid;
    grid.vertices.assign(vertices.begin(), vertices.end());
    grid.triangles.assign(triangles.begin(), triangles.end());
    grid.findBounds();
    placeGrid(grid, cell);
    if (!fillGrid(grid, TriangleTree(vertices, triangles)))
        throw InputError(
            fmt::format("the mesh encloses no volume that cells of {:g} m see; close it, or lower `cell`", cell));
    return grid;
}

}  // namespace knuckle
