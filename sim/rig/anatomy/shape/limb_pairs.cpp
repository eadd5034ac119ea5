#include "sim/rig/anatomy/shape/limb_pairs.h"

#include <algorithm>

namespace knuckle {

using Eigen::Vector3f;

namespace {

constexpr float ALIKE = 0.75f;  // the least ratio of the lengths of two that mirror each other
constexpr float OFF = 0.25f;    // the most that the ends of two that do are off each other's images [length]

constexpr float POSED = 0.2f;      // ... which counts as this far off if only their poses differ
constexpr size_t LIMB = 3;         // least bones of a limb that continues in what it holds
constexpr float POSED_OFF = 0.1f;  // the most that the first heads of those are off each other's images, and that bone
                                   // lengths differ [length]

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

/// The number of bones, of two chains that begin at each other's images, with equal lengths: up to there they mirror
/// each other except for their pose; beyond may be what one holds in its hand.
size_t alike(const BoneTree& tree, const MirrorPlane& plane, const BoneChain& a, const BoneChain& b)
{
    const float apart = POSED_OFF * std::min(a.length, b.length);
    const auto head = [&](const BoneChain& chain, size_t i) { return tree.heads[chain.bones[i]]; };
    if ((plane.mirrored(head(a, 0)) - head(b, 0)).norm() > apart) return 0;
    size_t count = 1;
    for (; count < std::min(a.bones.size(), b.bones.size()); ++count) {
        const float own = (head(a, count) - head(a, count - 1)).norm();
        const float other = (head(b, count) - head(b, count - 1)).norm();
        if (std::abs(own - other) > apart) break;
    }
    return count;
}

float mismatch(const BoneTree& tree, const MirrorPlane& plane, const BoneChain& a, const BoneChain& b)
{
    const float longer = std::max(a.length, b.length), shorter = std::min(a.length, b.length);
    if (longer <= 0.0f || shorter < ALIKE * longer) return 1.0f;
    const Vector3f image = plane.mirrored(tree.heads[a.bones.back()]);
    return (image - tree.heads[b.bones.back()]).norm() / longer;
}

BoneChain cutTo(const BoneTree& tree, BoneChain chain, size_t count)
{
    for (size_t i = count; i < chain.bones.size(); ++i)
        chain.length -= (tree.heads[chain.bones[i]] - tree.heads[chain.bones[i - 1]]).norm();
    chain.bones.resize(count);
    chain.fork = std::min(chain.fork, count - 1);
    return chain;
}

Vector3f middleOf(const BoneTree& tree, const BoneChain& chain)
{
    Vector3f sum = Vector3f::Zero();
    for (const uint32_t b : chain.bones) sum += tree.heads[b];
    return sum / static_cast<float>(chain.bones.size());
}

/// Whether a bone belongs to the trunk: next to the plane, with bones on both sides of it below.
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
            size_t best = sides[1].size(), bones = 0;
            float least = OFF;
            for (size_t i = 0; i < sides[1].size(); ++i) {
                const BoneChain& right = sides[1][i];
                const float off = mismatch(tree, plane, left, right);
                const size_t same = off < OFF ? 0 : alike(tree, plane, left, right);
                const bool whole = same == left.bones.size() && same == right.bones.size();
                const float counts = off >= OFF && (whole || same >= LIMB) ? POSED : off;
                if (counts >= least) continue;
                best = i, bones = same, least = counts;
            }
            if (best == sides[1].size()) continue;
            LimbPair pair{base, {left, sides[1][best]}};
            if (bones > 0)
                for (BoneChain& chain : pair.chains) chain = cutTo(tree, std::move(chain), bones);
            const auto tip = [&](const BoneChain& chain) { return tree.tips[chain.bones.back()].y(); };
            pair.lowest = std::min(tip(pair.chains[0]), tip(pair.chains[1]));
            pairs.push_back(std::move(pair));
            sides[1].erase(sides[1].begin() + static_cast<std::ptrdiff_t>(best));
        }
    }
    return pairs;
}

}  // namespace knuckle
