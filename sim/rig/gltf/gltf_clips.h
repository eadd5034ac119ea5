#pragma once

#include "sim/rig/gltf/glb.h"
#include "sim/rig/gltf/gltf_file.h"

namespace knuckle {

/// A bone against its parent.
struct LocalPose {
    Eigen::Vector3f translation;
    Eigen::Quaternionf rotation;
};

/// @param pose of all bones in the model's space; their scale is removed.
LocalPose localPose(const Model& model, const std::vector<Eigen::Matrix4f>& pose, size_t bone);
/// A bone's pose without scale.
Eigen::Matrix4f rigidPose(const Eigen::Matrix4f& pose);

/// Appends a clip to the animation of its name: every bone's turns, and its places if they differ from its rest pose.
/// @param firstBone node of the model's first bone.
void addClip(GltfFile& file, const Model& model, const Clip& clip, size_t firstBone, const GlbOptions& options);

}  // namespace knuckle
