#include "sim/rig/import/assimp/nodes/bones.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <span>
#include <string>
#include <tuple>
#include <utility>

#include "sim/base/errors.h"
#include "sim/rig/import/assimp/nodes/figure_nodes.h"
#include "sim/rig/import/assimp/nodes/moved_nodes.h"
#include "sim/rig/import/assimp/nodes/shown_meshes.h"

namespace knuckle {

namespace {

constexpr size_t BONE_LIMIT = 4096;
constexpr double SAME = 1e-3;  // difference of two ways to skin a mesh, in its size

using NodesByName = std::map<std::string, std::vector<uint32_t>>;

/// Finds the figure of each mesh if several figures have bones of the same names: the one whose bones move the mesh
/// least from its place, of equal ones the one that it hangs nearest to. If that leaves a figure without a mesh, meshes
/// are assigned in the order of the file.
class NamesakeFinder {
public:
    NamesakeFinder(const NodeTable& table, const NodesByName& byName) : table_(table), byName_(byName) {}

    void add(const aiMesh& mesh, uint32_t node)
    {
        // A single bone may share its name with a mesh.
        const std::span bones(mesh.mBones, mesh.mNumBones);
        const size_t figures = bones.size() < FEWEST_SKINNED ? 1 : nodesOf(*bones.front()).size();
        const auto isShared = [&](const aiBone* bone) { return nodesOf(*bone).size() == figures; };
        if (figures < 2 || !std::ranges::all_of(bones, isShared)) return;
        std::tuple<double, size_t> best{INFINITY, 0};
        size_t chosen = figures;
        for (size_t figure = 0; figure < figures; ++figure) {
            const double off = std::round(offset(mesh, node, figure) / SAME);
            const std::tuple found{off, table_.nodes.size() - depth(mesh, node, figure)};
            if (found == best) chosen = figures;  // undecided
            if (found < best) chosen = figure;
            best = std::min(best, found);
        }
        meshes_[figures].push_back({&mesh, chosen});
    }

    void decide(std::map<const aiBone*, uint32_t>& boneNodes) const
    {
        for (const auto& [figures, meshes] : meshes_) {
            std::set<size_t> found;
            for (const auto& [mesh, figure] : meshes) found.insert(figure);
            const bool isTold = found.size() == figures && *found.rbegin() < figures;
            for (size_t m = 0; m < meshes.size(); ++m) {
                const aiMesh& mesh = *meshes[m].first;
                const size_t figure = isTold ? meshes[m].second : m * figures / meshes.size();
                for (const aiBone* bone : std::span(mesh.mBones, mesh.mNumBones))
                    boneNodes[bone] = nodesOf(*bone)[figure];
            }
        }
    }

private:
    const std::vector<uint32_t>& nodesOf(const aiBone& bone) const { return byName_.at(bone.mName.C_Str()); }

    /// How far bones move the corners of a mesh's bounds from their place, over its size.
    double offset(const aiMesh& mesh, uint32_t node, size_t figure) const
    {
        Eigen::AlignedBox3d box;
        for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
            const aiVector3D& p = mesh.mVertices[v];
            box.extend(Eigen::Vector3d(p.x, p.y, p.z));
        }
        const Eigen::Matrix4d& own = table_.globals[node];
        double sum = 0.0;
        for (const aiBone* bone : std::span(mesh.mBones, mesh.mNumBones)) {
            const Eigen::Matrix4d moved = table_.globals[nodesOf(*bone)[figure]] * toEigen(bone->mOffsetMatrix);
            for (const auto corner : {Eigen::AlignedBox3d::BottomLeftFloor, Eigen::AlignedBox3d::TopRightCeil})
                sum += ((moved - own) * box.corner(corner).homogeneous()).norm();
        }
        const double size = (own.topLeftCorner<3, 3>() * box.sizes()).norm();
        return std::isfinite(sum) && size > 0.0 ? sum / size : 0.0;
    }

    size_t depth(const aiMesh& mesh, uint32_t node, size_t figure) const
    {
        size_t depth = 0;
        for (const aiBone* bone : std::span(mesh.mBones, mesh.mNumBones))
            depth = std::max(depth, table_.sharedDepth(node, nodesOf(*bone)[figure]));
        return depth;
    }

    const NodeTable& table_;
    const NodesByName& byName_;
    std::map<size_t, std::vector<std::pair<const aiMesh*, size_t>>> meshes_;  ///< By number of figures.
};

/// The first node of a skeleton without a mesh: below nodes that only hold it, such as scenes and armatures, which no
/// clip moves and from which nothing else branches.
uint32_t skeletonTop(const aiScene& scene, const NodeTable& table)
{
    std::set<std::string> moved;
    for (const aiAnimation* clip : std::span(scene.mAnimations, scene.mNumAnimations))
        for (const aiNodeAnim* channel : std::span(clip->mChannels, clip->mNumChannels))
            moved.insert(channel->mNodeName.C_Str());
    const aiNode* top = scene.mRootNode;
    while (!moved.contains(top->mName.C_Str())) {
        std::vector<const aiNode*> branches;
        for (const aiNode* child : std::span(top->mChildren, top->mNumChildren))
            if (child->mNumChildren > 0 || moved.contains(child->mName.C_Str())) branches.push_back(child);
        if (branches.size() != 1) break;
        top = branches.front();
    }
    return table.indices.at(top);
}

std::vector<uint32_t> bareBones(const aiScene& scene, const NodeTable& table)
{
    std::set<std::string> others;
    for (const aiCamera* camera : std::span(scene.mCameras, scene.mNumCameras)) others.insert(camera->mName.C_Str());
    for (const aiLight* light : std::span(scene.mLights, scene.mNumLights)) others.insert(light->mName.C_Str());
    const uint32_t top = skeletonTop(scene, table);
    std::vector<uint8_t> isBelow(table.nodes.size(), 0);
    std::vector<uint32_t> bones;
    for (uint32_t n = top; n < table.nodes.size(); ++n) {
        isBelow[n] = n == top || isBelow[static_cast<size_t>(table.parents[n])];
        const std::string name = table.nodes[n]->mName.C_Str();
        if (isBelow[n] && !isPivot(name) && !others.contains(name)) bones.push_back(n);
    }
    return bones;
}

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
    NamesakeFinder finder(table, byName);
    forEachMesh(scene, table, [&](const aiMesh& mesh, uint32_t node) { finder.add(mesh, node); });
    finder.decide(table.boneNodes);
}

std::vector<uint32_t> bonesIn(const aiScene& scene, const NodeTable& table)
{
    if (table.isBare) return bareBones(scene, table);
    std::set<uint32_t> bones;
    for (const auto& [bone, node] : table.boneNodes) bones.insert(node);
    if (bones.empty() && table.isOfParts) {
        const std::vector<uint32_t> moved = movedNodes(scene, table);
        return moved.empty() ? figureNodes(table) : moved;
    }
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

Eigen::Matrix4f bonePose(const Eigen::Matrix4d& global)
{
    Eigen::Matrix4d pose = global;
    if (pose.topLeftCorner<3, 3>().determinant() < 0.0) pose.col(2) *= -1.0;
    return pose.cast<float>();
}

void convertBones(const std::vector<uint32_t>& nodes, NodeTable& table, Model& model)
{
    if (nodes.size() > BONE_LIMIT)
        throw InputError(fmt::format("it has {} bones, at most {} are read", nodes.size(), BONE_LIMIT));
    const std::vector<std::string> names = boneNames(table, nodes);
    for (size_t b = 0; b < nodes.size(); ++b) {
        Bone bone{names[b], table.boneAbove(nodes[b])};
        bone.restPose = bonePose(table.globals[nodes[b]]);
        table.boneOf[nodes[b]] = static_cast<int32_t>(b);
        model.bones.push_back(bone);
    }
}

}  // namespace knuckle
