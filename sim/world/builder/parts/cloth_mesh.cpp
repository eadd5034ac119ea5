#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

#include "sim/base/errors.h"
#include "sim/world/builder/parts/cloth.h"

namespace knuckle {

namespace {

using Pair = std::array<uint32_t, 2>;
using Triangle = std::array<uint32_t, 3>;

Pair ordered(uint32_t a, uint32_t b)
{
    return {std::min(a, b), std::max(a, b)};
}

/// Vertices nearer to each other than this are merged [diameters].
constexpr float WELD = 1e-3f;
/// Two consecutive edges of a row bend by no more than 60 degrees.
constexpr float STRAIGHT = 0.5f;

struct Mesh {
    std::vector<Vector3f> nodes;
    std::vector<Triangle> triangles;
};

Mesh weld(std::span<const Vector3f> vertices, std::span<const Triangle> triangles, float size)
{
    Mesh mesh;
    std::map<std::array<int64_t, 3>, uint32_t> known;
    std::vector<uint32_t> nodeOf;
    for (const Vector3f& v : vertices) {
        const Eigen::Array<int64_t, 3, 1> cell = (v.cast<double>() / size).array().round().cast<int64_t>();
        const auto [place, isNew] = known.try_emplace({cell.x(), cell.y(), cell.z()}, mesh.nodes.size());
        if (isNew) mesh.nodes.push_back(v);
        nodeOf.push_back(place->second);
    }
    for (const Triangle& t : triangles) {
        const Triangle welded = {nodeOf[t[0]], nodeOf[t[1]], nodeOf[t[2]]};
        if (welded[0] != welded[1] && welded[1] != welded[2] && welded[2] != welded[0])
            mesh.triangles.push_back(welded);
    }
    return mesh;
}

/// Halves every edge longer than `longest`, and cuts the triangles beside it. @returns whether there was one.
bool refine(Mesh& mesh, float longest)
{
    std::map<Pair, uint32_t> middles;
    for (const Triangle& t : mesh.triangles)
        for (int e = 0; e < 3; ++e) {
            const Pair edge = ordered(t[e], t[(e + 1) % 3]);
            const Vector3f a = mesh.nodes[edge[0]], b = mesh.nodes[edge[1]];
            if ((a - b).norm() <= longest || middles.contains(edge)) continue;
            middles[edge] = static_cast<uint32_t>(mesh.nodes.size());
            mesh.nodes.push_back(0.5f * (a + b));
        }
    if (middles.empty()) return false;
    std::vector<Triangle> cut;
    for (const Triangle& t : mesh.triangles) {
        // The corners in order, with the middles of the edges that were halved between them. Three middles make four
        // triangles; one or two are cut as a fan.
        std::vector<uint32_t> ring;
        std::vector<uint32_t> own;
        for (int e = 0; e < 3; ++e) {
            const auto middle = middles.find(ordered(t[e], t[(e + 1) % 3]));
            ring.push_back(t[e]);
            if (middle == middles.end()) continue;
            ring.push_back(middle->second);
            own.push_back(middle->second);
        }
        if (own.size() == 3) {
            for (int e = 0; e < 3; ++e) cut.push_back({t[e], own[e], own[(e + 2) % 3]});
            cut.push_back({own[0], own[1], own[2]});
            continue;
        }
        // The fan starts at a middle: from a corner, one of its triangles could have three points on a line.
        if (!own.empty()) std::rotate(ring.begin(), std::find(ring.begin(), ring.end(), own.front()), ring.end());
        for (size_t k = 2; k < ring.size(); ++k) cut.push_back({ring[0], ring[k - 1], ring[k]});
    }
    mesh.triangles = std::move(cut);
    return true;
}

/// Joins pairs of nodes to rows as straight as possible, each pair in one row.
class StrandFinder {
public:
    StrandFinder(const std::vector<Vector3f>& nodes, const std::vector<Pair>& pairs)
        : nodes_(nodes), pairs_(pairs), used_(pairs.size(), false), pairsOf_(nodes.size())
    {
        for (uint32_t p = 0; p < pairs.size(); ++p)
            for (uint32_t node : pairs[p]) pairsOf_[node].push_back(p);
    }

    std::vector<std::vector<uint32_t>> rows()
    {
        std::vector<std::vector<uint32_t>> rows;
        for (uint32_t p = 0; p < pairs_.size(); ++p) {
            if (used_[p]) continue;
            used_[p] = true;
            std::vector<uint32_t> row = {pairs_[p][0], pairs_[p][1]};
            for (int side = 0; side < 2; ++side) {
                while (goOn(row)) {
                }
                std::reverse(row.begin(), row.end());
            }
            rows.push_back(std::move(row));
        }
        return rows;
    }

private:
    bool goOn(std::vector<uint32_t>& row)
    {
        const uint32_t end = row.back();
        const Vector3f way = (nodes_[end] - nodes_[row[row.size() - 2]]).normalized();
        float straightest = STRAIGHT;
        uint32_t best = NO_INDEX, next = NO_INDEX;
        for (uint32_t p : pairsOf_[end]) {
            const uint32_t other = pairs_[p][0] == end ? pairs_[p][1] : pairs_[p][0];
            const float along = way.dot((nodes_[other] - nodes_[end]).normalized());
            if (used_[p] || along <= straightest || std::find(row.begin(), row.end(), other) != row.end()) continue;
            straightest = along;
            best = p;
            next = other;
        }
        if (best == NO_INDEX) return false;
        used_[best] = true;
        row.push_back(next);
        return true;
    }

    const std::vector<Vector3f>& nodes_;
    const std::vector<Pair>& pairs_;
    std::vector<bool> used_;
    std::vector<std::vector<uint32_t>> pairsOf_;
};

void addStrands(ClothSheet& sheet, const std::vector<Pair>& pairs, DistanceKind kind, float compliance, float tearForce)
{
    for (std::vector<uint32_t>& nodes : StrandFinder(sheet.nodes, pairs).rows()) {
        Strand row;
        row.kind = kind;
        row.compliance = compliance;
        row.tearForce = tearForce;
        for (size_t k = 1; k < nodes.size(); ++k)
            row.restLengths.push_back((sheet.nodes[nodes[k]] - sheet.nodes[nodes[k - 1]]).norm());
        row.particles = std::move(nodes);
        sheet.strands.push_back(std::move(row));
    }
}

}  // namespace

ClothSheet meshSheet(std::span<const Vector3f> vertices, std::span<const Triangle> triangles, float diameter,
                     const ClothSpec& spec, size_t limit)
{
    Mesh mesh = weld(vertices, triangles, WELD * diameter);
    const auto checkSize = [&] {
        if (mesh.nodes.size() <= limit) return;
        throw InputError(
            fmt::format("the cloth has more than {} particles; raise the diameter or use a smaller mesh", limit));
    };
    do checkSize();
    while (refine(mesh, diameter));
    ClothSheet sheet;
    sheet.areas.assign(mesh.nodes.size(), 0.0f);
    std::map<Pair, std::vector<uint32_t>> opposite;  // per edge, the corners across
    float area = 0.0f;
    for (const Triangle& t : mesh.triangles) {
        const Vector3f a = mesh.nodes[t[1]] - mesh.nodes[t[0]], b = mesh.nodes[t[2]] - mesh.nodes[t[0]];
        const float part = a.cross(b).norm() / 6.0f;
        for (int e = 0; e < 3; ++e) {
            sheet.areas[t[e]] += part;
            area += part;
            opposite[ordered(t[e], t[(e + 1) % 3])].push_back(t[(e + 2) % 3]);
        }
    }
    if (!(area > 0.0f)) throw InputError("the cloth's mesh has no area; give one with triangles");
    // Vertices without a triangle, or only with slivers, get a little mass, too: masses must be above zero.
    const float least = 1e-3f * area / static_cast<float>(mesh.nodes.size());
    for (float& share : sheet.areas) share = std::max(share, least);
    sheet.nodes = std::move(mesh.nodes);
    sheet.triangles = std::move(mesh.triangles);
    std::vector<Pair> edges, across;
    for (const auto& [edge, corners] : opposite) {
        edges.push_back(edge);
        if (corners.size() != 2 || corners[0] == corners[1]) continue;
        const Pair pair = ordered(corners[0], corners[1]);
        if (!opposite.contains(pair)) across.push_back(pair);
    }
    std::sort(across.begin(), across.end());
    across.erase(std::unique(across.begin(), across.end()), across.end());
    addStrands(sheet, edges, DistanceKind::Stretch, spec.stretchCompliance, spec.tearForce);
    if (std::isfinite(spec.bendCompliance))
        addStrands(sheet, across, DistanceKind::Bend, spec.bendCompliance, spec.tearForce);
    return sheet;
}

}  // namespace knuckle
