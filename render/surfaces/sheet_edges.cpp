#include "render/surfaces/sheet_edges.h"

#include <map>
#include <set>
#include <utility>

namespace knuckle {

TriangleFans makeFans(size_t vertexCount, std::span<const Triangle> triangles)
{
    TriangleFans fans;
    fans.starts.assign(vertexCount + 1, 0);
    for (const Triangle& triangle : triangles)
        for (const uint32_t corner : triangle) ++fans.starts[corner + 1];
    for (size_t i = 0; i < vertexCount; ++i) fans.starts[i + 1] += fans.starts[i];
    std::vector<uint32_t> next(fans.starts.begin(), fans.starts.end() - 1);
    fans.triangles.resize(3 * triangles.size());
    for (uint32_t t = 0; t < triangles.size(); ++t)
        for (const uint32_t corner : triangles[t]) fans.triangles[next[corner]++] = t;
    return fans;
}

std::vector<gpu::uvec4> borderEdges(std::span<const Triangle> triangles)
{
    std::set<std::pair<uint32_t, uint32_t>> edges;
    for (const auto& [a, b, c] : triangles)
        for (const auto& edge : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) edges.insert(edge);
    std::map<uint32_t, uint32_t> before, after;
    for (const auto& [a, b] : edges) {
        if (edges.contains({b, a})) continue;
        after[a] = b;
        before[b] = a;
    }
    std::vector<gpu::uvec4> rows;
    for (const auto& [a, b] : after)
        rows.push_back({before.contains(a) ? before[a] : a, a, b, after.contains(b) ? after[b] : b});
    return rows;
}

}  // namespace knuckle
