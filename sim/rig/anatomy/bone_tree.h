#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "sim/rig/model.h"
#include "sim/world/world.h"

namespace knuckle {

/// A skeleton with ways down as well as up.
struct BoneTree {
    explicit BoneTree(const Model& model);

    std::vector<int32_t> parents;
    std::vector<std::vector<uint32_t>> children;
    std::vector<Eigen::Vector3f> heads;  ///< At rest [m].
    std::vector<Eigen::Vector3f> tips;   ///< Of its own skin the farthest from its head, which it is without any [m].
    std::vector<int> sides;              ///< As names say: +1 left, -1 right, 0 neither.
    bool hasSkin = false;
    std::vector<uint8_t> deforms;  ///< Has weights; everything does where the model has no skin.
    std::vector<uint8_t> carries;  ///< It or something below it has weights.

    uint32_t size() const { return static_cast<uint32_t>(parents.size()); }
    /// Per bone how many are above it.
    std::vector<uint32_t> depths() const;
    /// Whether a bone is `ancestor` or below it.
    bool isBelow(int32_t bone, uint32_t ancestor) const;
    /// The nearest bone above, -1 for none.
    int32_t above(uint32_t bone, const std::function<bool(uint32_t)>& counts) const;
    /// The nearest bone below, of equally near ones the first; -1 for none.
    int32_t below(uint32_t bone, const std::function<bool(uint32_t)>& counts) const;
    /// Per bone how many bones on it is, up and down; NO_INDEX where no way leads.
    std::vector<uint32_t> stepsFrom(uint32_t bone) const;
};

}  // namespace knuckle
