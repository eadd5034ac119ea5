#pragma once

#include <limits>
#include <string>
#include <vector>

#include "sim/rig/anatomy/bone_tree.h"
#include "sim/rig/bodies/bone_bodies.h"
#include "sim/rig/mesh/voxelize.h"

namespace knuckle {

/// Where two bodies come nearest.
struct Contact {
    float distance = std::numeric_limits<float>::infinity();  ///< [m]
    Eigen::Vector3f middle{0, 0, 0};                          ///< Mean of the middles of the nearest pairs
};

/// For bodies with thousands of particles, compares only every n-th one.
Contact contactOf(const std::vector<uint32_t>& a, const std::vector<uint32_t>& b, const Voxels& voxels);

/// Makes one tree of the bodies, parents first. Its root is the hips, else the body that most hangs on. Further roots
/// join the body nearest in the skeleton, of equally near ones that nearest in space: limbs join the trunk, and none
/// joins the other side. If that body is apart from them and another is at their bone's head (a foot on a control),
/// they join the latter. Joints whose bone's head is away from both bodies move to where these meet.
void arrangeTree(std::vector<BodyDraft>& drafts, const BoneTree& tree, std::span<const BoneAnatomy> anatomy,
                 const Voxels& voxels, std::vector<std::string>& notes);

}  // namespace knuckle
