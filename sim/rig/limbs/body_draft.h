#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "sim/base/no_index.h"

namespace knuckle {

/// A body before its joints are made: a bone, and the particles of it and of the bones merged into it.
struct BodyDraft {
    std::string name;
    uint32_t bone = NO_INDEX;
    int32_t parent = -1;              ///< Into the list of drafts; parents come first.
    std::vector<uint32_t> particles;  ///< Into Voxels, ascending.
    std::vector<uint32_t> mergedBones;
    Eigen::Vector3f anchor{0, 0, 0};  ///< Place of its joint with the parent [m].
};

/// Whether four or more points do not lie in one plane, within a tenth of a diameter.
bool spansSpace(const std::vector<Eigen::Vector3f>& points, float diameter);

}  // namespace knuckle
