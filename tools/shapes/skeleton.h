#pragma once

#include <Eigen/Core>
#include <span>
#include <string>
#include <vector>

#include "sim/rig/model.h"

namespace knuckle {

/// A bone as specified: of a pair only the left one, whose name ends in ".L".
struct BoneSpec {
    const char* name;
    const char* parent;          ///< Empty for the root; must be listed earlier.
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

/// The bones of the middle and of both sides (x and -x): each left limb is followed by its mirror image.
/// @throws std::logic_error for a parent that is not listed before its child.
Skeleton mirrored(std::span<const BoneSpec> specs);
/// @throws std::logic_error if no bone has that name.
uint32_t boneIndex(const Skeleton& skeleton, const std::string& name);
/// For Model: every bone's axes parallel to the model's.
std::vector<Bone> bonesOf(const Skeleton& skeleton);
/// Weights of the four nearest bones, as rounded as the vertices; import makes their sum one.
SkinWeights weightsAt(const Skeleton& skeleton, const Eigen::Vector3d& vertex);

}  // namespace knuckle
