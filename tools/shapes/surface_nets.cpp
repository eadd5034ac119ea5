#include "tools/shapes/surface_nets.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <unordered_map>

#include "sim/base/no_index.h"

namespace knuckle {

using Eigen::Vector3d;
using Eigen::Vector3i;

namespace {

constexpr int PROJECTION_STEPS = 3;
constexpr double GRADIENT_STEP = 5e-4;  // [m]
constexpr double GRAIN = 1e-4;          // [m]
constexpr double HIGHEST_STEP = 0.012;  // largest excess over a true distance [m]
constexpr int COORDINATE_BITS = 20;     // of a place in a key

// Places and sides of cells in units of the smallest cells.
struct Leaf {
    Vector3i low;
    int side;
    Vector3d sum = Vector3d::Zero();  // of the points where the surface crosses edges around it
    int crossings = 0;
    uint32_t vertex = NO_INDEX;
};

uint64_t keyOf(const Vector3i& p)
{
    return (static_cast<uint64_t>(p.z()) << COORDINATE_BITS | static_cast<uint64_t>(p.y())) << COORDINATE_BITS |
           static_cast<uint64_t>(p.x());
}

class Octree {
public:
    Octree(const Distance& distance, const NetGrid& grid) : distance_(distance), grid_(grid)
    {
        side_ = 1 << grid.levels;
        low_ = grid.centre - Vector3d::Constant(0.5 * side_ * grid.finest);
        grow(Vector3i::Zero(), side_);
    }

    TriangleMesh mesh()
    {
        forEachEdge([&](const std::array<uint32_t, 4>& around, const Vector3i& a, const Vector3i& b) {
            const double va = valueAt(a), vb = valueAt(b);
            const Vector3d crossing = position(a) + va / (va - vb) * (position(b) - position(a));
            for (const uint32_t leaf : around) {
                leaves_[leaf].sum += crossing;
                ++leaves_[leaf].crossings;
            }
        });
        TriangleMesh mesh;
        for (Leaf& leaf : leaves_) {
            if (leaf.crossings == 0) continue;
            leaf.vertex = static_cast<uint32_t>(mesh.vertices.size());
            mesh.vertices.push_back(onSurface(distance_, leaf.sum / leaf.crossings).cast<float>());
        }
        forEachEdge([&](const std::array<uint32_t, 4>& around, const Vector3i& a, const Vector3i&) {
            std::array<uint32_t, 4> quad{};
            for (size_t i = 0; i < 4; ++i) quad[i] = leaves_[around[i]].vertex;
            if (valueAt(a) >= 0.0) std::swap(quad[1], quad[3]);
            addQuad(quad, mesh);
        });
        return mesh;
    }

private:
    Vector3d position(const Vector3i& p) const { return low_ + grid_.finest * p.cast<double>(); }

    void grow(const Vector3i& low, int side)
    {
        const double size = side * grid_.finest;
        const Vector3d centre = position(low) + Vector3d::Constant(0.5 * size);
        if (std::abs(distance_(centre)) > 0.5 * std::sqrt(3.0) * size + HIGHEST_STEP) return;
        if (side > 1 && size > grid_.cellAt(centre)) {
            for (int i = 0; i < 8; ++i) grow(low + side / 2 * Vector3i(i & 1, i >> 1 & 1, i >> 2 & 1), side / 2);
            return;
        }
        leafAt_[keyOf(low)] = static_cast<uint32_t>(leaves_.size());
        leaves_.push_back({low, side});
    }

    // The leaf that contains the smallest cell at a place.
    uint32_t leafAround(const Vector3i& p) const
    {
        if (p.minCoeff() < 0 || p.maxCoeff() >= side_) throw std::logic_error("the surface leaves the grid");
        for (int side = 1; side <= side_; side *= 2) {
            const Vector3i low = p.unaryExpr([&](int c) { return c & ~(side - 1); });
            const auto found = leafAt_.find(keyOf(low));
            if (found != leafAt_.end() && leaves_[found->second].side == side) return found->second;
        }
        return NO_INDEX;
    }

    double valueAt(const Vector3i& p)
    {
        const auto [place, isNew] = values_.try_emplace(keyOf(p));
        if (isNew) place->second = distance_(position(p));
        return place->second;
    }

    // Undivided edges that cross the surface, each once, with the leaves around them in order.
    template <typename Visit>
    void forEachEdge(const Visit& visit)
    {
        for (uint32_t l = 0; l < leaves_.size(); ++l) {
            const int side = leaves_[l].side;
            for (int edge = 0; edge < 12; ++edge) {
                const int axis = edge / 4;
                const Vector3i u = Vector3i::Unit((axis + 1) % 3), v = Vector3i::Unit((axis + 2) % 3);
                const Vector3i a = leaves_[l].low + side * ((edge & 1) * u + (edge >> 1 & 1) * v);
                const Vector3i b = a + side * Vector3i::Unit(axis);
                if ((valueAt(a) < 0.0) == (valueAt(b) < 0.0)) continue;
                const std::array<uint32_t, 4> around{leafAround(a - u - v), leafAround(a - v), leafAround(a),
                                                     leafAround(a - u)};
                if (std::ranges::count(around, NO_INDEX) > 0) throw std::logic_error("the distance is too steep");
                // The first of the smallest leaves around an edge owns the edge.
                const auto owner = std::ranges::min_element(around, {}, [&](uint32_t i) { return leaves_[i].side; });
                if (*owner == l) visit(around, a, b);
            }
        }
    }

    // Adds two triangles along the shorter diagonal, or one if a large leaf has two of the corners.
    static void addQuad(const std::array<uint32_t, 4>& q, TriangleMesh& mesh)
    {
        const auto length = [&](size_t i, size_t j) { return (mesh.vertices[q[i]] - mesh.vertices[q[j]]).norm(); };
        const size_t first = length(0, 2) <= length(1, 3) ? 0 : 1;
        for (const size_t i : {first, first + 2}) {
            const Triangle triangle{q[i % 4], q[(i + 1) % 4], q[(i + 2) % 4]};
            if (triangle[0] != triangle[1] && triangle[1] != triangle[2] && triangle[2] != triangle[0])
                mesh.triangles.push_back(triangle);
        }
    }

    const Distance& distance_;
    const NetGrid& grid_;
    int side_ = 0;
    Vector3d low_;
    std::vector<Leaf> leaves_;
    std::unordered_map<uint64_t, uint32_t> leafAt_;
    std::unordered_map<uint64_t, double> values_;
};

}  // namespace

Vector3d gradient(const Distance& distance, const Vector3d& p, double h)
{
    Vector3d g;
    for (int axis = 0; axis < 3; ++axis) {
        g[axis] = (distance(p + h * Vector3d::Unit(axis)) - distance(p - h * Vector3d::Unit(axis))) / (2.0 * h);
    }
    return g;
}

Vector3d onSurface(const Distance& distance, const Vector3d& p)
{
    Vector3d point = p;
    for (int i = 0; i < PROJECTION_STEPS; ++i) {
        const Vector3d g = gradient(distance, point, GRADIENT_STEP);
        point -= distance(point) / std::max(g.squaredNorm(), 0.1) * g;
    }
    return (point / GRAIN).array().round() * GRAIN;
}

TriangleMesh surfaceNets(const Distance& distance, const NetGrid& grid)
{
    return Octree(distance, grid).mesh();
}

}  // namespace knuckle
