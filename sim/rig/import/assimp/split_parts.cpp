#include "sim/rig/import/assimp/split_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "sim/base/disjoint_sets.h"
#include "sim/base/errors.h"
#include "sim/rig/import/assimp/nodes/shown_meshes.h"

namespace knuckle {

namespace {

constexpr size_t PART_LIMIT = 4096;

/// The vertices of one mesh at one node.
struct Run {
    uint32_t node = 0;
    std::string mesh, material;
    uint32_t end = 0;  ///< One past its last vertex.
};

std::string baseName(const Run& run, const NodeTable& table)
{
    std::string node = table.nameOf(run.node);
    if (table.parents[run.node] >= 0 && isGivenName(node)) return node;
    return isGivenName(run.mesh) ? run.mesh : isGivenName(run.material) ? run.material : "part";
}

std::vector<Run> runsOf(const aiScene& scene, const NodeTable& table)
{
    std::vector<Run> runs;
    forEachMesh(scene, table, [&](const aiMesh& mesh, uint32_t node) {
        const uint32_t start = runs.empty() ? 0 : runs.back().end;
        const aiString material = mesh.mMaterialIndex < scene.mNumMaterials
                                      ? scene.mMaterials[mesh.mMaterialIndex]->GetName()
                                      : aiString();
        runs.push_back({node, mesh.mName.C_Str(), material.C_Str(), start + mesh.mNumVertices});
    });
    return runs;
}

/// Joins vertices that triangles connect, and those of one node at the same place.
DisjointSets connected(const Model& model, const std::vector<Run>& runs)
{
    DisjointSets sets(model.vertices.size());
    for (const auto& [a, b, c] : model.triangles) {
        sets.unite(a, b);
        sets.unite(a, c);
    }
    std::map<std::array<float, 3>, uint32_t> places;
    uint32_t vertex = 0;
    for (size_t r = 0; r < runs.size(); ++r) {
        if (r > 0 && runs[r].node != runs[r - 1].node) places.clear();
        for (; vertex < runs[r].end; ++vertex) {
            const Eigen::Vector3f& p = model.vertices[vertex];
            const auto [place, isNew] = places.try_emplace({p.x(), p.y(), p.z()}, vertex);
            if (!isNew) sets.unite(vertex, place->second);
        }
    }
    return sets;
}

/// Numbers parts that share a name.
std::vector<std::string> numbered(const std::vector<std::string>& names)
{
    std::map<std::string, int> counts, seen;
    for (const std::string& name : names) ++counts[name];
    std::vector<std::string> unique;
    for (const std::string& name : names) {
        std::string own = name;
        while (counts[name] > 1 || name == "part") {
            own = fmt::format("{}_{}", name, ++seen[name]);
            if (!counts.contains(own)) break;
        }
        unique.push_back(own);
    }
    return unique;
}

}  // namespace

void splitIntoParts(const aiScene& scene, const NodeTable& table, Model& model)
{
    if (!model.bones.empty()) throw InputError("it has a skeleton, which says what its bodies are: leave `split` away");
    const std::vector<Run> runs = runsOf(scene, table);
    DisjointSets sets = connected(model, runs);
    std::vector<uint32_t> drawn;  // the first vertex of each set that has a triangle
    for (const auto& triangle : model.triangles) drawn.push_back(sets.find(triangle[0]));
    std::ranges::sort(drawn);
    drawn.erase(std::unique(drawn.begin(), drawn.end()), drawn.end());
    if (drawn.size() > PART_LIMIT)
        throw InputError(fmt::format("it has {} separate parts, at most {} can be bodies: leave `split` away",
                                     drawn.size(), PART_LIMIT));
    std::vector<std::string> names;
    for (const uint32_t first : drawn) {
        const auto run = std::ranges::upper_bound(runs, first, {}, &Run::end);
        names.push_back(baseName(*run, table));
    }
    names = numbered(names);
    std::vector<Eigen::AlignedBox3f> bounds(drawn.size());
    model.skin.resize(model.vertices.size());
    for (uint32_t v = 0; v < model.vertices.size(); ++v) {
        const auto part = std::ranges::lower_bound(drawn, sets.find(v));
        model.skin[v].weights[0] = 1.0f;
        if (part == drawn.end() || *part != sets.find(v)) continue;  // of no triangle
        model.skin[v].bones[0] = static_cast<uint32_t>(part - drawn.begin());
        bounds[model.skin[v].bones[0]].extend(model.vertices[v]);
    }
    for (size_t p = 0; p < drawn.size(); ++p) {
        Bone bone{names[p], -1};
        bone.restPose.block<3, 1>(0, 3) = bounds[p].center();
        model.bones.push_back(bone);
    }
    model.isSplit = true;
}

}  // namespace knuckle
