#include "tools/shapes/surface_nets.h"

#include <cmath>

#include "sim/world/no_index.h"

namespace knuckle {

using Eigen::Vector3d;
using Eigen::Vector3i;

namespace {

constexpr int PROJECTION_STEPS = 2;
// Vertices are rounded to this [model unit], so that the last bits of the mathematical library do not show.
constexpr double GRAIN = 1e-4;

struct Grid {
    Vector3d low;
    double step;
    Vector3i counts;  // of sample points
    std::vector<double> values;

    size_t index(const Vector3i& p) const
    {
        return (static_cast<size_t>(p.z()) * counts.y() + p.y()) * counts.x() + p.x();
    }
    double at(const Vector3i& p) const { return values[index(p)]; }
    Vector3d position(const Vector3i& p) const { return low + step * p.cast<double>(); }
};

Vector3i corner(int i)
{
    return {i & 1, i >> 1 & 1, i >> 2 & 1};
}

// The mean of where the surface crosses the cell's edges; false where it does not.
bool cellVertex(const Grid& grid, const Vector3i& cell, Vector3d& vertex)
{
    Vector3d sum = Vector3d::Zero();
    int crossings = 0;
    for (int i = 0; i < 8; ++i) {
        for (int axis = 0; axis < 3; ++axis) {
            if (i >> axis & 1) {
                continue;
            }
            const Vector3i a = cell + corner(i), b = cell + corner(i | 1 << axis);
            const double va = grid.at(a), vb = grid.at(b);
            if ((va < 0.0) != (vb < 0.0)) {
                sum += grid.position(a) + va / (va - vb) * (grid.position(b) - grid.position(a));
                ++crossings;
            }
        }
    }
    vertex = sum / std::max(crossings, 1);
    return crossings > 0;
}

Vector3d gradient(const Distance& distance, const Vector3d& p, double h)
{
    Vector3d g;
    for (int axis = 0; axis < 3; ++axis) {
        g[axis] = (distance(p + h * Vector3d::Unit(axis)) - distance(p - h * Vector3d::Unit(axis))) / (2.0 * h);
    }
    return g;
}

Grid sample(const Distance& distance, const Vector3d& low, const Vector3d& high, double step)
{
    Grid grid{low, step, ((high - low) / step).array().ceil().cast<int>() + 1, {}};
    grid.values.reserve(static_cast<size_t>(grid.counts.prod()));
    for (int z = 0; z < grid.counts.z(); ++z) {
        for (int y = 0; y < grid.counts.y(); ++y) {
            for (int x = 0; x < grid.counts.x(); ++x) {
                grid.values.push_back(distance(grid.position({x, y, z})));
            }
        }
    }
    return grid;
}

// One quad per grid edge that crosses the surface, between the vertices of the four cells around it.
void addQuad(const Grid& grid, const std::vector<uint32_t>& cells, const Vector3i& p, int axis, TriangleMesh& mesh)
{
    const bool inside = grid.at(p) < 0.0;
    if (inside == (grid.at(p + Vector3i::Unit(axis)) < 0.0)) {
        return;
    }
    const Vector3i u = Vector3i::Unit((axis + 1) % 3), v = Vector3i::Unit((axis + 2) % 3);
    uint32_t quad[4] = {cells[grid.index(p - u - v)], cells[grid.index(p - v)], cells[grid.index(p)],
                        cells[grid.index(p - u)]};
    if (!inside) {
        std::swap(quad[1], quad[3]);
    }
    mesh.triangles.push_back({quad[0], quad[1], quad[2]});
    mesh.triangles.push_back({quad[0], quad[2], quad[3]});
}

}  // namespace

TriangleMesh surfaceNets(const Distance& distance, const Vector3d& low, const Vector3d& high, double step)
{
    const Grid grid = sample(distance, low, high, step);
    TriangleMesh mesh;
    std::vector<uint32_t> cells(grid.values.size(), NO_INDEX);
    const auto forEachCell = [&](auto visit) {
        for (int z = 0; z + 1 < grid.counts.z(); ++z) {
            for (int y = 0; y + 1 < grid.counts.y(); ++y) {
                for (int x = 0; x + 1 < grid.counts.x(); ++x) {
                    visit(Vector3i(x, y, z));
                }
            }
        }
    };
    forEachCell([&](const Vector3i& cell) {
        Vector3d vertex;
        if (!cellVertex(grid, cell, vertex)) {
            return;
        }
        for (int i = 0; i < PROJECTION_STEPS; ++i) {
            const Vector3d g = gradient(distance, vertex, 0.05 * step);
            vertex -= distance(vertex) / std::max(g.squaredNorm(), 0.1) * g;
        }
        cells[grid.index(cell)] = static_cast<uint32_t>(mesh.vertices.size());
        mesh.vertices.push_back(((vertex / GRAIN).array().round() * GRAIN).cast<float>());
    });
    forEachCell([&](const Vector3i& p) {
        for (int axis = 0; axis < 3; ++axis) {
            if (p[(axis + 1) % 3] > 0 && p[(axis + 2) % 3] > 0) {
                addQuad(grid, cells, p, axis, mesh);
            }
        }
    });
    return mesh;
}

}  // namespace knuckle
