#include "sim/rig/import/assimp/nodes/skeletons.h"

#include <assimp/commonMetaData.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <span>
#include <string_view>

#include "sim/base/disjoint_sets.h"
#include "sim/rig/anatomy/names/name_pattern.h"
#include "sim/rig/gltf/glb.h"
#include "sim/rig/import/assimp/nodes/bones.h"
#include "sim/rig/import/assimp/nodes/shown_meshes.h"
#include "sim/rig/import/skeleton_error.h"

namespace knuckle {

namespace {

constexpr size_t FEWEST_OWN = 2;  // least bones of a figure in an export of a run without a larger one

/// Bones below one root, or below several roots that a mesh connects.
struct Skeleton {
    std::string name;                    ///< Of the root with the most bones below it.
    uint32_t root = 0;                   ///< Its node.
    std::vector<uint32_t> nodes, roots;  ///< Of all its bones, ascending.
    size_t skinned = 0;                  ///< The largest number of bones that one mesh is skinned to.
};

/// Finds the skeletons of a scene by joining the trees of bones that share a mesh.
class SkeletonFinder {
public:
    SkeletonFinder(const aiScene& scene, const NodeTable& table)
        : table_(table), bones_(bonesIn(scene, table)), names_(boneNames(table, bones_)),
          rootOf_(table.nodes.size(), NO_INDEX), joined_(table.nodes.size())
    {
        std::vector<uint8_t> isBone(table.nodes.size(), 0);
        for (const uint32_t bone : bones_) isBone[bone] = 1;
        // Parents come first.
        for (uint32_t n = 0; n < table.nodes.size(); ++n) {
            const int32_t parent = table.parents[n];
            const uint32_t above = parent < 0 ? NO_INDEX : rootOf_[static_cast<size_t>(parent)];
            rootOf_[n] = above != NO_INDEX ? above : isBone[n] ? n : NO_INDEX;
        }
        forEachMesh(scene, table, [&](const aiMesh& mesh, uint32_t) { join(mesh); });
    }

    std::vector<Skeleton> find()
    {
        std::map<uint32_t, Skeleton> found;
        std::map<uint32_t, std::vector<uint32_t>> trees;
        for (const uint32_t bone : bones_) trees[rootOf_[bone]].push_back(bone);
        for (const auto& [root, nodes] : trees) {
            Skeleton& skeleton = found[joined_.find(root)];
            skeleton.roots.push_back(root);
            skeleton.nodes.insert(skeleton.nodes.end(), nodes.begin(), nodes.end());
            if (skeleton.name.empty() || nodes.size() > trees.at(skeleton.root).size()) {
                skeleton.root = root;
                skeleton.name = names_[static_cast<size_t>(std::ranges::lower_bound(bones_, root) - bones_.begin())];
            }
        }
        for (const auto& [root, count] : skinned_)
            found.at(joined_.find(root)).skinned = std::max(found.at(joined_.find(root)).skinned, count);
        std::vector<Skeleton> skeletons;
        for (auto& [root, skeleton] : found) {
            std::ranges::sort(skeleton.nodes);
            skeletons.push_back(std::move(skeleton));
        }
        return skeletons;
    }

private:
    void join(const aiMesh& mesh)
    {
        std::vector<uint32_t> roots;
        for (const aiBone* bone : std::span(mesh.mBones, mesh.mNumBones))
            if (moves(*bone)) roots.push_back(rootOf_[table_.boneNodes.at(bone)]);
        if (roots.empty()) return;
        for (const uint32_t root : roots) joined_.unite(root, roots.front());
        size_t& skinned = skinned_[roots.front()];
        skinned = std::max(skinned, roots.size());
    }

    const NodeTable& table_;
    std::vector<uint32_t> bones_;
    std::vector<std::string> names_;
    std::vector<uint32_t> rootOf_;        ///< Per node.
    DisjointSets joined_;                 ///< Roots of one skeleton.
    std::map<uint32_t, size_t> skinned_;  ///< By root: the number of a mesh's bones.
};

std::string listed(std::span<const Skeleton> skeletons)
{
    std::vector<std::string> texts;
    for (const Skeleton& skeleton : skeletons)
        texts.push_back(fmt::format("{} ({} bones)", skeleton.name, skeleton.nodes.size()));
    return fmt::format("{}", fmt::join(texts, ", "));
}

bool isWanted(const Skeleton& skeleton, const std::string& pattern)
{
    return skeleton.name == pattern || matchesPattern(skeleton.name, pattern);
}

/// Gives controls and props to the figure that they hang nearest to in the tree of nodes, unless two are equally near.
void giveAway(const std::vector<Skeleton>& others, const NodeTable& table, std::vector<Skeleton>& figures)
{
    for (const Skeleton& other : others) {
        std::vector<size_t> depths;
        for (const Skeleton& figure : figures) depths.push_back(table.sharedDepth(other.root, figure.root));
        const auto nearest = std::ranges::max_element(depths);
        if (std::ranges::count(depths, *nearest) > 1) continue;
        std::vector<uint32_t>& nodes = figures[static_cast<size_t>(nearest - depths.begin())].nodes;
        nodes.insert(nodes.end(), other.nodes.begin(), other.nodes.end());
        std::ranges::sort(nodes);
    }
}

/// Whether the file is an export of a run, in which each object has its own skeleton, of one bone or more.
bool isOwnExport(const aiScene& scene)
{
    aiString generator;
    return scene.mMetaData != nullptr && scene.mMetaData->Get(AI_METADATA_SOURCE_GENERATOR, generator) &&
           std::string_view(generator.C_Str()) == GLB_OF_OBJECTS;
}

}  // namespace

std::vector<uint32_t> pickSkeleton(const aiScene& scene, const ModelPick& pick, NodeTable& table,
                                   std::vector<std::string>& notes)
{
    std::vector<uint32_t> all = bonesIn(scene, table);
    if (pick.skeleton == ALL_SKELETONS || (table.isBare && pick.skeleton.empty())) return all;
    const std::vector<Skeleton> skeletons = SkeletonFinder(scene, table).find();
    const bool isOwn = isOwnExport(scene) && !table.isBare;
    // In an export, pairs beside a figure are no figures.
    const auto isFigure = [](const Skeleton& s) { return s.skinned >= FEWEST_SKINNED; };
    const size_t fewest = isOwn && std::ranges::none_of(skeletons, isFigure) ? FEWEST_OWN : FEWEST_SKINNED;
    std::vector<Skeleton> figures, others;
    for (const Skeleton& skeleton : skeletons)
        (table.isBare || skeleton.skinned >= fewest ? figures : others).push_back(skeleton);
    const bool isBeside = isOwn && !figures.empty() && !others.empty();
    if (isBeside && !pick.skeleton.empty()) figures = skeletons;
    if (isBeside) others.clear();
    if (figures.size() < 2 && !isBeside) {
        const bool known = std::ranges::any_of(skeletons,
                                               [&](const Skeleton& s) { return isWanted(s, pick.skeleton); });
        if (pick.skeleton.empty() || known) return all;
        throw SkeletonError(skeletons.empty() ? "it has no skeleton"
                                              : fmt::format("it has no skeleton '{}', but one: {}", pick.skeleton,
                                                            listed(std::span(skeletons).first(1))));
    }
    if (pick.skeleton.empty() && figures.size() > 1)
        throw SkeletonError(fmt::format("it holds {} skeletons: {}", figures.size(), listed(figures)));
    const std::string choice = listed(figures);
    giveAway(others, table, figures);
    std::vector<uint32_t> nodes;
    std::vector<std::string> taken;
    for (const Skeleton& figure : figures) {
        if (!pick.skeleton.empty() && !isWanted(figure, pick.skeleton)) continue;
        nodes.insert(nodes.end(), figure.nodes.begin(), figure.nodes.end());
        taken.push_back(figure.name);
    }
    if (taken.empty()) throw SkeletonError(fmt::format("it has no skeleton '{}', but {}", pick.skeleton, choice));
    std::ranges::sort(nodes);
    table.isPicked = true;
    notes.push_back(fmt::format("Of {} skeletons only {} was taken.", isBeside ? skeletons.size() : figures.size(),
                                fmt::join(taken, ", ")));
    return nodes;
}

}  // namespace knuckle
