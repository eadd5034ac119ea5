#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <span>
#include <string>
#include <tuple>

#include "sim/actor/import/import_scene.h"
#include "sim/world/errors.h"

namespace knuckle {

namespace {

constexpr size_t BONE_LIMIT = 4096;
constexpr double SAME = 1e-3;  // of two ways to skin a mesh, in its size

using NodesByName = std::map<std::string, std::vector<uint32_t>>;

/// Of several figures whose bones have the same names, the one that a mesh belongs to: where its vertices come nearest
/// to where the mesh stands when its bones move them, of equal ones that which hangs nearest to it.
class NamesakeFinder {
public:
    NamesakeFinder(const NodeTable& table, const NodesByName& byName) : table_(table), byName_(byName) {}

    void find(const aiMesh& mesh, uint32_t node, std::map<const aiBone*, uint32_t>& boneNodes) const
    {
        size_t figures = 1;
        for (const aiBone* bone : std::span(mesh.mBones, mesh.mNumBones))
            figures = std::max(figures, nodesOf(*bone).size());
        if (figures < 2) return;
        std::tuple<double, size_t> best{INFINITY, 0};
        size_t chosen = figures;
        for (size_t figure = 0; figure < figures; ++figure) {
            const double off = std::round(offset(mesh, node, figures, figure) / SAME);
            const std::tuple found{off, table_.nodes.size() - depth(mesh, node, figures, figure)};
            if (found == best) chosen = figures;  // as assimp has it
            if (found < best) chosen = figure;
            best = std::min(best, found);
        }
        if (chosen == figures) return;
        for (const aiBone* bone : std::span(mesh.mBones, mesh.mNumBones))
            if (nodesOf(*bone).size() == figures) boneNodes[bone] = nodesOf(*bone)[chosen];
    }

private:
    const std::vector<uint32_t>& nodesOf(const aiBone& bone) const { return byName_.at(bone.mName.C_Str()); }

    /// How far bones move the corners of a mesh's bounds from where it stands, in parts of its size.
    double offset(const aiMesh& mesh, uint32_t node, size_t figures, size_t figure) const
    {
        Eigen::AlignedBox3d box;
        for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
            const aiVector3D& p = mesh.mVertices[v];
            box.extend(Eigen::Vector3d(p.x, p.y, p.z));
        }
        const Eigen::Matrix4d& own = table_.globals[node];
        double sum = 0.0;
        for (const aiBone* bone : std::span(mesh.mBones, mesh.mNumBones)) {
            if (nodesOf(*bone).size() != figures) continue;
            const Eigen::Matrix4d moved = table_.globals[nodesOf(*bone)[figure]] * toEigen(bone->mOffsetMatrix);
            for (const auto corner : {Eigen::AlignedBox3d::BottomLeftFloor, Eigen::AlignedBox3d::TopRightCeil})
                sum += ((moved - own) * box.corner(corner).homogeneous()).norm();
        }
        const double size = (own.topLeftCorner<3, 3>() * box.sizes()).norm();
        return std::isfinite(sum) && size > 0.0 ? sum / size : 0.0;
    }

    size_t depth(const aiMesh& mesh, uint32_t node, size_t figures, size_t figure) const
    {
        size_t depth = 0;
        for (const aiBone* bone : std::span(mesh.mBones, mesh.mNumBones))
            if (nodesOf(*bone).size() == figures)
                depth = std::max(depth, table_.sharedDepth(node, nodesOf(*bone)[figure]));
        return depth;
    }

    const NodeTable& table_;
    const NodesByName& byName_;
};

}  // namespace

void findBoneNodes(const aiScene& scene, NodeTable& table)
{
    NodesByName byName;
    for (uint32_t n = 0; n < table.nodes.size(); ++n) byName[table.nodes[n]->mName.C_Str()].push_back(n);
    for (const aiMesh* mesh : std::span(scene.mMeshes, scene.mNumMeshes)) {
        for (const aiBone* bone : std::span(mesh->mBones, mesh->mNumBones)) {
            const auto named = byName.find(bone->mName.C_Str());
            if (named == byName.end())
                throw InputError(
                    fmt::format("bone '{}' is not among the scene's nodes: export the model with its skeleton",
                                bone->mName.C_Str()));
            const auto known = table.indices.find(bone->mNode);
            table.boneNodes[bone] = known != table.indices.end() ? known->second : named->second.front();
        }
    }
    const NamesakeFinder finder(table, byName);
    forEachMesh(scene, table, [&](const aiMesh& mesh, uint32_t node) { finder.find(mesh, node, table.boneNodes); });
}

std::vector<uint32_t> bonesIn(const aiScene& scene, const NodeTable& table)
{
    std::set<uint32_t> bones;
    for (const auto& [bone, node] : table.boneNodes) bones.insert(node);
    // A skeleton without a mesh: all of its nodes, but those that assimp makes for FBX pivots.
    for (uint32_t n = 0; n < table.nodes.size() && scene.mNumMeshes == 0; ++n)
        if (std::string(table.nodes[n]->mName.C_Str()).find("_$AssimpFbx$_") == std::string::npos) bones.insert(n);
    return {bones.begin(), bones.end()};
}

std::vector<std::string> boneNames(const NodeTable& table, const std::vector<uint32_t>& nodes)
{
    std::vector<std::string> names;
    std::map<std::string, int> seen;
    for (const uint32_t node : nodes) {
        std::string name = table.nameOf(node);
        if (name.empty()) name = fmt::format("bone {}", names.size());
        if (const int times = ++seen[name]; times > 1) name += fmt::format("#{}", times);
        names.push_back(name);
    }
    return names;
}

void convertBones(const std::vector<uint32_t>& nodes, NodeTable& table, Model& model)
{
    if (nodes.size() > BONE_LIMIT)
        throw InputError(fmt::format("it has {} bones, at most {} are read", nodes.size(), BONE_LIMIT));
    const std::vector<std::string> names = boneNames(table, nodes);
    for (size_t b = 0; b < nodes.size(); ++b) {
        Bone bone{names[b], table.boneAbove(nodes[b])};
        bone.restPose = table.globals[nodes[b]].cast<float>();
        table.boneOf[nodes[b]] = static_cast<int32_t>(b);
        model.bones.push_back(bone);
    }
}

}  // namespace knuckle
