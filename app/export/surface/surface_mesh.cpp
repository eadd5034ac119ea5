#include "app/export/surface/surface_mesh.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "app/export/surface/cell_order.h"

namespace knuckle {

namespace {

using Node = FluidField::Node;

constexpr float HALF = 0.5f;
/// Corners of a cell by number: bits are x, y, z.
constexpr int CORNERS = 8;
/// Edges of tetrahedra that begin at a node: towards corners 1 to 7 of its cell.
constexpr size_t WAYS = 7;

Node cornerOf(int corner)
{
    return {corner & 1, corner >> 1 & 1, corner >> 2};
}

/// A tetrahedron of a cell, positively oriented.
using Tetrahedron = std::array<int, 4>;
constexpr std::array<Tetrahedron, 6> TETRAHEDRA{
    {{0, 1, 3, 7}, {0, 3, 2, 7}, {0, 2, 6, 7}, {0, 6, 4, 7}, {0, 4, 5, 7}, {0, 5, 1, 7}}};

class Marcher {
public:
    explicit Marcher(const FluidField& field) : field_(field), vertices_(field.blocks().size()) {}

    SurfaceMesh march()
    {
        for (const FluidField::Block& block : field_.blocks())
            forEachCell(block.first, Node(block.first.array() + FluidField::BLOCK - 1),
                        [&](const Node& node) { cutCell(block, node); });
        return std::move(mesh_);
    }

private:
    /// The vertex of each edge that begins at a node of a block; 0: none yet, else it and 1.
    using BlockVertices = std::array<uint32_t, WAYS * FluidField::BLOCK * FluidField::BLOCK * FluidField::BLOCK>;

    void cutCell(const FluidField::Block& block, const Node& node)
    {
        node_ = node;
        const bool within = ((node - block.first).array() < FluidField::BLOCK - 1).all();
        int inside = 0;
        for (int corner = 0; corner < CORNERS; ++corner) {
            const Node at = node + cornerOf(corner);
            values_[static_cast<size_t>(corner)] = within ? block.values[FluidField::placeIn(block, at)]
                                                          : field_.valueAt(at);
            if (isInside(corner)) ++inside;
        }
        if (inside == 0 || inside == CORNERS) return;
        for (const Tetrahedron& tetrahedron : TETRAHEDRA) cut(tetrahedron);
    }

    bool isInside(int corner) const { return values_[static_cast<size_t>(corner)] > HALF; }

    /// Puts what is inside first, and counts whether that turns the tetrahedron round.
    void cut(Tetrahedron corners)
    {
        bool isOdd = false;
        for (size_t end = corners.size() - 1; end > 0; --end)
            for (size_t k = 0; k < end; ++k)
                if (!isInside(corners[k]) && isInside(corners[k + 1])) {
                    std::swap(corners[k], corners[k + 1]);
                    isOdd = !isOdd;
                }
        const auto& [a, b, c, d] = corners;
        const auto inside = std::ranges::count_if(corners, [&](int corner) { return isInside(corner); });
        if (inside == 1) add({vertexOn(a, b), vertexOn(a, c), vertexOn(a, d)}, isOdd);
        if (inside == 3) add({vertexOn(d, a), vertexOn(d, b), vertexOn(d, c)}, isOdd);
        if (inside != 2) return;
        const uint32_t ac = vertexOn(a, c), ad = vertexOn(a, d), bd = vertexOn(b, d), bc = vertexOn(b, c);
        add({ac, ad, bd}, isOdd);
        add({ac, bd, bc}, isOdd);
    }

    void add(std::array<uint32_t, 3> triangle, bool isOdd)
    {
        if (isOdd) std::swap(triangle[1], triangle[2]);
        mesh_.triangles.push_back(triangle);
    }

    /// Where the surface meets an edge, whichever cell asks first. One corner is below the other along all axes.
    uint32_t vertexOn(int one, int other)
    {
        const int from = std::min(one, other), to = std::max(one, other);
        const Node begin = node_ + cornerOf(from);
        const auto blockIndex = static_cast<size_t>(field_.blockAt(begin));
        if (!vertices_[blockIndex]) vertices_[blockIndex] = std::make_unique<BlockVertices>();
        const size_t place = FluidField::placeIn(field_.blocks()[blockIndex], begin);
        uint32_t& vertex = (*vertices_[blockIndex])[WAYS * place + static_cast<size_t>(to - from) - 1];
        if (vertex != 0) return vertex - 1;
        const float low = values_[static_cast<size_t>(from)], high = values_[static_cast<size_t>(to)];
        const float part = (HALF - low) / (high - low);
        const Eigen::Vector3f way = (cornerOf(to) - cornerOf(from)).cast<float>();
        mesh_.places.emplace_back(field_.step() * (begin.cast<float>() + part * way));
        const Eigen::Vector3f slope = (1.0f - part) * slopeAt(begin) + part * slopeAt(node_ + cornerOf(to));
        mesh_.normals.push_back((-slope).stableNormalized());
        vertex = static_cast<uint32_t>(mesh_.places.size());
        return vertex - 1;
    }

    Eigen::Vector3f slopeAt(const Node& node) const
    {
        Eigen::Vector3f slope;
        for (int axis = 0; axis < 3; ++axis)
            slope[axis] = field_.valueAt(node + Node::Unit(axis)) - field_.valueAt(node - Node::Unit(axis));
        return slope;
    }

    const FluidField& field_;
    std::vector<std::unique_ptr<BlockVertices>> vertices_;  ///< By block; null: none.
    SurfaceMesh mesh_;
    Node node_{0, 0, 0};                      ///< Where the cell begins.
    std::array<float, CORNERS> values_ = {};  ///< At its corners.
};

}  // namespace

SurfaceMesh surfaceOf(const FluidField& field)
{
    return Marcher(field).march();
}

}  // namespace knuckle
