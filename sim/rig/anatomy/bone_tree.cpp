#include "sim/rig/anatomy/bone_tree.h"

#include "sim/rig/anatomy/names/bone_name.h"

namespace knuckle {

BoneTree::BoneTree(const Model& model)
    : children(model.bones.size()), hasSkin(!model.skin.empty()), deforms(model.bones.size(), model.skin.empty())
{
    for (uint32_t b = 0; b < model.bones.size(); ++b) {
        const int32_t parent = model.bones[b].parent;
        parents.push_back(parent);
        sides.push_back(readBoneName(model.bones[b].name).side);
        heads.push_back(boneHead(model, b));
        if (parent >= 0) children[parent].push_back(b);
    }
    tips = heads;
    for (size_t v = 0; v < model.skin.size(); ++v) {
        const SkinWeights& skin = model.skin[v];
        for (size_t i = 0; i < skin.bones.size(); ++i) {
            const uint32_t b = skin.bones[i];
            deforms[b] |= skin.weights[i] > 0.0f;
            const Eigen::Vector3f& place = model.vertices[v];
            const bool own = skin.weights[i] > 0.5f;
            if (own && (place - heads[b]).squaredNorm() > (tips[b] - heads[b]).squaredNorm()) tips[b] = place;
        }
    }
    carries = deforms;
    for (uint32_t b = size(); b-- > 0;)
        if (parents[b] >= 0) carries[parents[b]] |= carries[b];
}

std::vector<uint32_t> BoneTree::depths() const
{
    std::vector<uint32_t> depths(size(), 0);
    for (uint32_t b = 0; b < size(); ++b)
        if (parents[b] >= 0) depths[b] = depths[parents[b]] + 1;
    return depths;
}

bool BoneTree::isBelow(int32_t bone, uint32_t ancestor) const
{
    while (bone >= 0 && bone != static_cast<int32_t>(ancestor)) bone = parents[bone];
    return bone >= 0;
}

int32_t BoneTree::above(uint32_t bone, const std::function<bool(uint32_t)>& counts) const
{
    int32_t found = parents[bone];
    while (found >= 0 && !counts(static_cast<uint32_t>(found))) found = parents[found];
    return found;
}

int32_t BoneTree::below(uint32_t bone, const std::function<bool(uint32_t)>& counts) const
{
    std::vector<uint32_t> queue = children[bone];
    for (size_t i = 0; i < queue.size(); ++i) {
        if (counts(queue[i])) return static_cast<int32_t>(queue[i]);
        queue.insert(queue.end(), children[queue[i]].begin(), children[queue[i]].end());
    }
    return -1;
}

std::vector<uint32_t> BoneTree::stepsFrom(uint32_t bone) const
{
    std::vector<uint32_t> steps(size(), NO_INDEX), queue{bone};
    steps[bone] = 0;
    for (size_t i = 0; i < queue.size(); ++i) {
        const auto reach = [&](uint32_t other) {
            if (steps[other] != NO_INDEX) return;
            steps[other] = steps[queue[i]] + 1;
            queue.push_back(other);
        };
        const uint32_t from = queue[i];
        if (parents[from] >= 0) reach(static_cast<uint32_t>(parents[from]));
        for (const uint32_t child : children[from]) reach(child);
    }
    return steps;
}

}  // namespace knuckle
