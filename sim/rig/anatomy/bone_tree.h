#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "sim/rig/model.h"
#include "sim/world/world.h"

namespace knuckle {

/// A skeleton with links from bones to their children as well as to their parents.
struct BoneTree {
    explicit BoneTree(const Model& model);

    std::vector<int32_t> parents;
    std::vector<std::vector<uint32_t>> children;
    std::vector<Eigen::Vector3f> heads;  ///< At rest [m].
    std::vector<Eigen::Vector3f> tips;   ///< The point of its own skin farthest from its head; without skin the head
                                         ///< [m].
    std::vector<int> sides;              ///< By names: +1 left, -1 right, 0 neither.
    bool hasSkin = false;
    std::vector<uint8_t> deforms;  ///< Has weights; true for all if the model has no skin.
    std::vector<uint8_t> carries;  ///< It or something below it has weights.

    uint32_t size() const { return static_cast<uint32_t>(parents.size()); }
    /// Per bone, how many bones are above it.
    std::vector<uint32_t> depths() const;
    /// Whether a bone is `ancestor` or below it.
    bool isBelow(int32_t bone, uint32_t ancestor) const;
    /// The nearest bone above, -1 for none.
    int32_t above(uint32_t bone, const std::function<bool(uint32_t)>& counts) const;
    /// The nearest bone below, of equally near ones the first; -1 for none.
    int32_t below(uint32_t bone, const std::function<bool(uint32_t)>& counts) const;
    /// Per bone, the number of steps from the bone, up and down; NO_INDEX if it is not connected.
    std::vector<uint32_t> stepsFrom(uint32_t bone) const;
};

}  // namespace knuckle
