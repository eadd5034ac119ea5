#include "sim/rig/mesh/open_edges.h"

#include <algorithm>
#include <map>
#include <utility>

#include "sim/base/disjoint_sets.h"

namespace knuckle {

using Eigen::Vector3f;

namespace {

using Edge = std::array<uint32_t, 2>;  ///< In the direction of its triangle.

/// Of each vertex the first at its place.
std::vector<uint32_t> firstAtPlace(std::span<const Vector3f> vertices)
{
    std::map<std::array<float, 3>, uint32_t> places;
    std::vector<uint32_t> firsts;
    for (const Vector3f& v : vertices)
        firsts.push_back(places.try_emplace({v.x(), v.y(), v.z()}, static_cast<uint32_t>(firsts.size())).first->second);
    return firsts;
}

/// Triangles over the first vertices at their places, without those that have no area.
std::vector<Triangle> welded(std::span<const Vector3f> vertices, std::span<const Triangle> triangles)
{
    const std::vector<uint32_t> firsts = firstAtPlace(vertices);
    std::vector<Triangle> kept;
    for (const Triangle& t : triangles) {
        const Triangle joined{firsts[t[0]], firsts[t[1]], firsts[t[2]]};
        if (joined[0] != joined[1] && joined[1] != joined[2] && joined[2] != joined[0]) kept.push_back(joined);
    }
    return kept;
}

/// Edges of one triangle only, in order.
std::vector<Edge> openEdges(const std::vector<Triangle>& triangles)
{
    std::map<Edge, std::pair<uint32_t, Edge>> uses;
    for (const Triangle& t : triangles)
        for (size_t k = 0; k < 3; ++k) {
            const Edge edge{t[k], t[(k + 1) % 3]};
            auto& [count, direction] = uses[{std::min(edge[0], edge[1]), std::max(edge[0], edge[1])}];
            ++count;
            direction = edge;
        }
    std::vector<Edge> open;
    for (const auto& [key, use] : uses)
        if (use.first == 1) open.push_back(use.second);
    return open;
}

}  // namespace

float widestOpening(std::span<const Vector3f> vertices, std::span<const Triangle> triangles)
{
    const std::vector<Edge> open = openEdges(welded(vertices, triangles));
    DisjointSets rims(vertices.size());
    for (const auto& [from, to] : open) rims.unite(from, to);
    std::map<uint32_t, Eigen::AlignedBox3f> boxes;
    float widest = 0.0f;
    for (const Edge& edge : open) {
        Eigen::AlignedBox3f& box = boxes[rims.find(edge[0])];
        for (const uint32_t v : edge) box.extend(vertices[v]);
        widest = std::max(widest, box.diagonal().norm());
    }
    return widest;
}

TriangleMesh thickened(std::span<const Vector3f> vertices, std::span<const Triangle> triangles, float thickness)
{
    const std::vector<Triangle> sheet = welded(vertices, triangles);
    std::vector<Vector3f> normals(vertices.size(), Vector3f::Zero());
    for (const Triangle& t : sheet)
        for (const uint32_t v : t)
            normals[v] += (vertices[t[1]] - vertices[t[0]]).cross(vertices[t[2]] - vertices[t[0]]);
    TriangleMesh shell;
    for (const float side : {0.5f, -0.5f})
        for (size_t v = 0; v < vertices.size(); ++v)
            shell.vertices.push_back(vertices[v] + side * thickness * normals[v].stableNormalized());
    const auto behind = [&](uint32_t v) { return v + static_cast<uint32_t>(vertices.size()); };
    for (const auto& [a, b, c] : sheet) {
        shell.triangles.push_back({a, b, c});
        shell.triangles.push_back({behind(a), behind(c), behind(b)});
    }
    for (const auto& [a, b] : openEdges(sheet)) {
        shell.triangles.push_back({b, a, behind(a)});
        shell.triangles.push_back({b, behind(a), behind(b)});
    }
    return shell;
}

}  // namespace knuckle
