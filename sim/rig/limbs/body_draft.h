#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "sim/base/no_index.h"

namespace knuckle {

/// A body before its joints are made: a bone, and the particles that it and the bones merged into it took.
struct BodyDraft {
    std::string name;
    uint32_t bone = NO_INDEX;
    int32_t parent = -1;              ///< Into the list of drafts; parents come first.
    std::vector<uint32_t> particles;  ///< Into Voxels, ascending.
    std::vector<uint32_t> mergedBones;
    Eigen::Vector3f anchor{0, 0, 0};  ///< Where its joint with the parent sits [m].
};

/// Four or more points that do not lie in one plane, give or take a tenth of a diameter.
bool spansSpace(const std::vector<Eigen::Vector3f>& points, float diameter);

}  // namespace knuckle
