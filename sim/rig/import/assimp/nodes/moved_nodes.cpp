#include "sim/rig/import/assimp/nodes/moved_nodes.h"

#include <algorithm>
#include <set>
#include <span>
#include <string>

namespace knuckle {

namespace {

constexpr double STILL = 1e-5;  // variation of key values that still counts as no motion

template <typename Key>
bool varies(const Key* keys, unsigned count)
{
    const auto differs = [&](const Key& key) {
        const auto &a = key.mValue, &b = keys[0].mValue;
        double off = std::max({std::abs(a.x - b.x), std::abs(a.y - b.y), std::abs(a.z - b.z)});
        if constexpr (requires { a.w; }) off = std::max(off, double{std::abs(a.w - b.w)});
        return off > STILL;
    };
    return std::any_of(keys, keys + count, differs);
}

/// Names of the nodes that any clip moves.
std::set<std::string> movedNames(const aiScene& scene)
{
    std::set<std::string> moved;
    for (const aiAnimation* clip : std::span(scene.mAnimations, scene.mNumAnimations))
        for (const aiNodeAnim* channel : std::span(clip->mChannels, clip->mNumChannels))
            if (varies(channel->mPositionKeys, channel->mNumPositionKeys) ||
                varies(channel->mRotationKeys, channel->mNumRotationKeys) ||
                varies(channel->mScalingKeys, channel->mNumScalingKeys))
                moved.insert(channel->mNodeName.C_Str());
    return moved;
}

/// The node that moves together with another node's meshes: itself or one above; NO_INDEX: none.
uint32_t moverOf(uint32_t node, const NodeTable& table, const std::set<std::string>& moved)
{
    uint32_t mover = node;
    for (auto n = static_cast<int32_t>(node); n >= 0; n = table.parents[static_cast<size_t>(n)]) {
        const std::string name = table.nodes[static_cast<size_t>(n)]->mName.C_Str();
        if (!isPivot(name)) mover = static_cast<uint32_t>(n);
        if (moved.contains(name)) return mover;
    }
    return NO_INDEX;
}

}  // namespace

std::vector<uint32_t> movedNodes(const aiScene& scene, const NodeTable& table)
{
    const std::set<std::string> moved = movedNames(scene);
    std::set<uint32_t> bones;
    uint32_t common = NO_INDEX;
    bool isAnyStill = false;
    for (uint32_t n = 0; n < table.nodes.size(); ++n) {
        if (table.nodes[n]->mNumMeshes == 0) continue;
        common = common == NO_INDEX ? n : table.commonNode(common, n);
        const uint32_t mover = moverOf(n, table, moved);
        if (mover == NO_INDEX) isAnyStill = true;
        else bones.insert(mover);
    }
    if (isAnyStill && !bones.empty()) bones.insert(common);
    return {bones.begin(), bones.end()};
}

}  // namespace knuckle
