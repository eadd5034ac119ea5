#include "sim/rig/mesh/distance_grid.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "sim/base/errors.h"
#include "sim/rig/mesh/open_edges.h"

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

/// The place of every value, x fastest.
template <typename Visit>
void forEachPlace(const ColliderGrid& grid, Visit visit)
{
    for (int z = 0; z < grid.counts.z(); ++z)
        for (int y = 0; y < grid.counts.y(); ++y)
            for (int x = 0; x < grid.counts.x(); ++x)
                visit(x, Vector3f(grid.low + grid.cell.cwiseProduct(Eigen::Vector3i(x, y, z).cast<float>())));
}

/// @param open its sides may change where no triangle is. @returns whether any value is inside.
bool fillGrid(ColliderGrid& grid, const TriangleTree& tree, bool open)
{
    bool anyInside = false, inside = false;
    float before = 0.0f;  // distance of the value before on the row
    grid.values.reserve(grid.counts.cast<size_t>().prod());
    forEachPlace(grid, [&](int x, const Vector3f& point) {
        const float distance = tree.nearest(point).distance;
        // If one of two neighbours is further than a cell from a closed surface, no triangle lies between them and both
        // are on the same side. 1.5 cells, since a point on the surface itself has no certain side.
        if (open || x == 0 || std::max(before, distance) <= 1.5f * grid.cell.x()) inside = tree.inside(point);
        grid.values.push_back(inside ? -distance : distance);
        anyInside |= inside;
        before = distance;
    });
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
    const bool open = widestOpening(vertices, triangles) > 0.0f;
    if (!fillGrid(grid, TriangleTree(vertices, triangles), open))
        throw InputError(fmt::format("the mesh encloses no volume that cells of {:g} m see; close it, lower `cell`, or "
                                     "give a sheet a `thickness`",
                                     cell));
    return grid;
}

ColliderGrid makeSheetGrid(std::span<const Vector3f> vertices, std::span<const Triangle> triangles, float cell,
                           float thickness)
{
    if (triangles.empty()) throw InputError("the model has no triangles");
    ColliderGrid grid;
    TriangleMesh shell = thickened(vertices, triangles, thickness);
    grid.vertices.assign(vertices.begin(), vertices.end());
    grid.findBounds();
    grid.drawnLow.array() -= 0.5f * thickness;
    grid.drawnHigh.array() += 0.5f * thickness;
    placeGrid(grid, cell);
    const TriangleTree tree(vertices, triangles);
    forEachPlace(grid, [&](int, const Vector3f& point) {
        grid.values.push_back(tree.nearest(point).distance - 0.5f * thickness);
    });
    grid.vertices = std::move(shell.vertices);
    grid.triangles = std::move(shell.triangles);
    return grid;
}

}  // namespace knuckle
