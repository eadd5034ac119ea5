#pragma once

#include <optional>

#include "sim/rig/anatomy/bone_tree.h"

namespace knuckle {

/// The upright plane in which a skeleton is its own mirror image.
struct MirrorPlane {
    Eigen::Vector3f across{1, 0, 0};  ///< Unit, level.
    float offset = 0.0f;              ///< Of the plane along it [m].

    float distance(const Eigen::Vector3f& point) const { return point.dot(across) - offset; }
    Eigen::Vector3f mirrored(const Eigen::Vector3f& point) const { return point - 2 * distance(point) * across; }
};

/// The plane in which most bones have a mirror image, of the other side if names give sides, and fewest have none; none
/// if hardly any bone has an image.
std::optional<MirrorPlane> findMirrorPlane(const BoneTree& tree);

/// The longest side of the box around all bones' heads [m].
float sizeOf(const BoneTree& tree);

}  // namespace knuckle
