#pragma once

#include <Eigen/Core>
#include <span>
#include <string>
#include <vector>

#include "sim/rig/model.h"

namespace knuckle {

/// A bone as it is written down: of pairs the left one alone, whose name ends in ".L".
struct BoneSpec {
    const char* name;
    const char* parent;          ///< Empty for the root; stands before it.
    Eigen::Vector3d head, tail;  ///< [m]
    double radius;               ///< Of the flesh around it [m].
};

struct SkeletonBone {
    std::string name;
    int32_t parent = -1;
    Eigen::Vector3d head, tail;  ///< [m]
    double radius = 0.0;         ///< [m]
};

/// Parents come before their children.
using Skeleton = std::vector<SkeletonBone>;

/// The bones of the middle and both sides (x and -x): each limb of the left is followed by its mirror image.
/// @throws std::logic_error for a parent that does not stand before its child.
Skeleton mirrored(std::span<const BoneSpec> specs);
/// @throws std::logic_error where there is none of that name.
uint32_t boneIndex(const Skeleton& skeleton, const std::string& name);
/// For Model: every bone's axes parallel to the model's.
std::vector<Bone> bonesOf(const Skeleton& skeleton);
/// Four bones, by how near they are, as rounded as the vertices; import makes the sum one.
SkinWeights weightsAt(const Skeleton& skeleton, const Eigen::Vector3d& vertex);

}  // namespace knuckle
