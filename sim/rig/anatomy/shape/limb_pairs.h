#pragma once

#include <array>

#include "sim/rig/anatomy/shape/mirror_plane.h"

namespace knuckle {

/// Bones one below the other.
struct BoneChain {
    std::vector<uint32_t> bones;
    float length = 0.0f;  ///< Of all its segments [m].
    size_t fork = 0;      ///< Into bones: the first after which the chain branches, or the last.
};

/// Two chains from one bone that mirror each other.
struct LimbPair {
    uint32_t base = 0;
    std::array<BoneChain, 2> chains;  ///< The first is where the plane's distance is positive.
    float lowest = 0.0f;              ///< Height of the end [m].

    float length() const { return chains[0].length; }
    size_t count() const { return std::min(chains[0].bones.size(), chains[1].bones.size()); }
};

/// The longest way down from a bone, over bones that carry skin.
BoneChain chainFrom(const BoneTree& tree, uint32_t bone);

/// Pairs of two or more bones each, in the order of the bones that they hang on.
std::vector<LimbPair> findLimbPairs(const BoneTree& tree, const MirrorPlane& plane);

}  // namespace knuckle
