#include "sim/actor/anatomy/limb_pairs.h"

#include <algorithm>

namespace knuckle {

using Eigen::Vector3f;

namespace {

constexpr float ALIKE = 0.75f;  // the shorter of two that mirror each other is this share of the longer at least
constexpr float OFF = 0.25f;    // the ends of two that do are this far off each other's images at most [length]

constexpr float POSED = 0.2f;      // ... which counts as this far off where only their poses differ
constexpr float POSED_OFF = 0.1f;  // of those, off each other's images at the first head, and of their bones [length]

/// The longest way down from each bone [m].
std::vector<float> reaches(const BoneTree& tree)
{
    std::vector<float> reach(tree.size(), 0.0f);
    for (uint32_t b = tree.size(); b-- > 0;) {
        const int32_t parent = tree.parents[b];
        if (parent < 0 || !tree.carries[b]) continue;
        reach[parent] = std::max(reach[parent], reach[b] + (tree.heads[b] - tree.heads[parent]).norm());
    }
    return reach;
}

BoneChain chainAlong(const BoneTree& tree, const std::vector<float>& reach, uint32_t bone)
{
    BoneChain chain{{bone}};
    bool forked = false;
    while (true) {
        const uint32_t last = chain.bones.back();
        int32_t next = -1;
        int branches = 0;
        float farthest = -1.0f;
        for (const uint32_t child : tree.children[last]) {
            if (!tree.carries[child]) continue;
            ++branches;
            const float far = reach[child] + (tree.heads[child] - tree.heads[last]).norm();
            if (far <= farthest) continue;
            farthest = far;
            next = static_cast<int32_t>(child);
        }
        if (!forked) chain.fork = chain.bones.size() - 1;
        forked |= branches > 1;
        if (next < 0) return chain;
        chain.length += (tree.heads[next] - tree.heads[last]).norm();
        chain.bones.push_back(static_cast<uint32_t>(next));
    }
}

/// Whether two begin at each other's images and have as long bones: they do mirror each other, but for their pose.
bool arePosed(const BoneTree& tree, const MirrorPlane& plane, const BoneChain& a, const BoneChain& b)
{
    const float apart = POSED_OFF * std::max(a.length, b.length);
    const auto head = [&](const BoneChain& chain, size_t i) { return tree.heads[chain.bones[i]]; };
    if (a.bones.size() != b.bones.size() || (plane.mirrored(head(a, 0)) - head(b, 0)).norm() > apart) return false;
    for (size_t i = 1; i < a.bones.size(); ++i) {
        const float own = (head(a, i) - head(a, i - 1)).norm(), other = (head(b, i) - head(b, i - 1)).norm();
        if (std::abs(own - other) > apart) return false;
    }
    return true;
}

float mismatch(const BoneTree& tree, const MirrorPlane& plane, const BoneChain& a, const BoneChain& b)
{
    const float longer = std::max(a.length, b.length), shorter = std::min(a.length, b.length);
    if (longer <= 0.0f || shorter < ALIKE * longer) return 1.0f;
    const Vector3f image = plane.mirrored(tree.heads[a.bones.back()]);
    const float most = arePosed(tree, plane, a, b) ? POSED : 1.0f;
    return std::min(most, (image - tree.heads[b.bones.back()]).norm() / longer);
}

Vector3f middleOf(const BoneTree& tree, const BoneChain& chain)
{
    Vector3f sum = Vector3f::Zero();
    for (const uint32_t b : chain.bones) sum += tree.heads[b];
    return sum / static_cast<float>(chain.bones.size());
}

/// Whether a bone is of the trunk: next to the plane, with bones on both sides of it below.
bool isCentral(const BoneTree& tree, const MirrorPlane& plane, float beside, uint32_t bone)
{
    if (std::abs(plane.distance(tree.heads[bone])) > beside) return false;
    bool sides[2] = {false, false};
    for (uint32_t b = bone; b < tree.size(); ++b) {
        const float away = plane.distance(tree.heads[b]);
        if (tree.carries[b] && std::abs(away) > beside && tree.isBelow(static_cast<int32_t>(b), bone))
            sides[away < 0] = true;
    }
    return sides[0] && sides[1];
}

}  // namespace

BoneChain chainFrom(const BoneTree& tree, uint32_t bone)
{
    return chainAlong(tree, reaches(tree), bone);
}

std::vector<LimbPair> findLimbPairs(const BoneTree& tree, const MirrorPlane& plane)
{
    const std::vector<float> reach = reaches(tree);
    const float beside = 0.02f * sizeOf(tree);
    std::vector<LimbPair> pairs;
    for (uint32_t base = 0; base < tree.size(); ++base) {
        std::vector<BoneChain> sides[2];
        for (const uint32_t child : tree.children[base]) {
            if (!tree.carries[child] || isCentral(tree, plane, beside, child)) continue;
            BoneChain chain = chainAlong(tree, reach, child);
            const float away = plane.distance(middleOf(tree, chain));
            if (chain.bones.size() >= 2 && std::abs(away) > beside) sides[away < 0].push_back(std::move(chain));
        }
        for (const BoneChain& left : sides[0]) {
            size_t best = sides[1].size();
            float least = OFF;
            for (size_t i = 0; i < sides[1].size(); ++i) {
                const float off = mismatch(tree, plane, left, sides[1][i]);
                if (off < least) best = i, least = off;
            }
            if (best == sides[1].size()) continue;
            const float lowest = std::min(tree.tips[left.bones.back()].y(), tree.tips[sides[1][best].bones.back()].y());
            pairs.push_back({base, {left, sides[1][best]}, lowest});
            sides[1].erase(sides[1].begin() + static_cast<std::ptrdiff_t>(best));
        }
    }
    return pairs;
}

}  // namespace knuckle
