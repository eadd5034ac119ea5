#include "sim/rig/import/assimp/nodes/node_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>

#include "sim/base/errors.h"
#include "sim/rig/import/valid_text.h"

namespace knuckle {

namespace {

constexpr size_t NODE_LIMIT = 100000;
constexpr size_t DEPTH_LIMIT = 1000;

// FBX keeps the up axis as metadata and leaves the data unchanged.
Eigen::Matrix4d uprightFrom(const aiScene& scene)
{
    int32_t upAxis = 1;
    if (scene.mMetaData != nullptr) {
        scene.mMetaData->Get("UpAxis", upAxis);
    }
    Eigen::Matrix4d upright = Eigen::Matrix4d::Identity();
    if (upAxis == 2) {
        upright.row(1).swap(upright.row(2));
        upright.row(2) *= -1.0;
    } else if (upAxis == 0) {
        upright.row(0).swap(upright.row(1));
        upright.row(0) *= -1.0;
    }
    return upright;
}

}  // namespace

Eigen::Matrix4d toEigen(const aiMatrix4x4& m)
{
    Eigen::Matrix4d e;
    e << m.a1, m.a2, m.a3, m.a4, m.b1, m.b2, m.b3, m.b4, m.c1, m.c2, m.c3, m.c4, m.d1, m.d2, m.d3, m.d4;
    return e;
}

int32_t NodeTable::boneAbove(uint32_t node) const
{
    int32_t n = static_cast<int32_t>(node);
    while (n >= 0 && boneOf[n] < 0) {
        n = parents[n];
    }
    return n < 0 ? -1 : boneOf[n];
}

size_t NodeTable::sharedDepth(uint32_t a, uint32_t b) const
{
    const auto depthOf = [&](int32_t node) {
        size_t depth = 0;
        for (; node >= 0; node = parents[node]) ++depth;
        return depth;
    };
    auto x = static_cast<int32_t>(a), y = static_cast<int32_t>(b);
    size_t depthX = depthOf(x), depthY = depthOf(y);
    for (; depthX > depthY; --depthX) x = parents[x];
    for (; depthY > depthX; --depthY) y = parents[y];
    for (; x != y; --depthX) {
        x = parents[x];
        y = parents[y];
    }
    return depthX;
}

uint32_t NodeTable::commonNode(uint32_t a, uint32_t b) const
{
    // Parents come first.
    while (a != b) {
        uint32_t& lower = a > b ? a : b;
        lower = static_cast<uint32_t>(parents[lower]);
    }
    return a;
}

std::string NodeTable::nameOf(uint32_t node) const
{
    const std::string name = nodes[node]->mName.C_Str();
    const auto original = originals.find(name);
    return validText(original == originals.end() ? name : original->second);
}

NodeTable listNodes(const aiScene& scene)
{
    struct Visit {
        const aiNode* node;
        int32_t parent;
        size_t depth;
    };
    NodeTable table;
    table.upright = uprightFrom(scene);
    std::vector<Visit> stack{{scene.mRootNode, -1, 0}};
    while (!stack.empty()) {
        const Visit visit = stack.back();
        stack.pop_back();
        if (visit.depth > DEPTH_LIMIT || table.nodes.size() >= NODE_LIMIT) {
            throw InputError(fmt::format("its node tree is deeper than {} or has more than {} nodes: simplify it",
                                         DEPTH_LIMIT, NODE_LIMIT));
        }
        const uint32_t index = static_cast<uint32_t>(table.nodes.size());
        const Eigen::Matrix4d local = toEigen(visit.node->mTransformation);
        table.nodes.push_back(visit.node);
        table.parents.push_back(visit.parent);
        table.locals.push_back(visit.parent < 0 ? Eigen::Matrix4d(table.upright * local) : local);
        table.indices[visit.node] = index;
        for (unsigned c = visit.node->mNumChildren; c-- > 0;) {
            stack.push_back({visit.node->mChildren[c], static_cast<int32_t>(index), visit.depth + 1});
        }
    }
    table.fbx = FbxNodes(table.nodes, table.parents);
    table.globals = table.fbx.place(table.locals, table.parents);
    for (size_t n = 0; n < table.nodes.size(); ++n)
        if (!table.globals[n].allFinite())
            throw InputError(
                fmt::format("node '{}' has a transform that is not a number", table.nodes[n]->mName.C_Str()));
    table.boneOf.assign(table.nodes.size(), -1);
    return table;
}

bool moves(const aiBone& bone)
{
    return std::ranges::any_of(std::span(bone.mWeights, bone.mNumWeights),
                               [](const aiVertexWeight& weight) { return weight.mWeight > 0.0f; });
}

bool NodeTable::takes(const aiMesh& mesh, uint32_t node) const
{
    if (apart.contains({&mesh, node})) return false;
    if (!isPicked) return true;
    if (mesh.mNumBones == 0) return boneAbove(node) >= 0;
    return std::ranges::any_of(std::span(mesh.mBones, mesh.mNumBones),
                               [&](const aiBone* bone) { return moves(*bone) && boneOf[boneNodes.at(bone)] >= 0; });
}

bool isGivenName(std::string_view name)
{
    constexpr std::array<std::string_view, 4> MADE_UP{"<", "mesh_", "nodes[", "meshes["};
    const auto isMadeUp = [&](std::string_view start) { return name.starts_with(start); };
    return !name.empty() && name != "defaultobject" && name != "DefaultMaterial" && name != "ROOT" &&
           std::ranges::none_of(MADE_UP, isMadeUp);
}

}  // namespace knuckle
