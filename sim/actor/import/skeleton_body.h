#pragma once

#include "sim/actor/import/model.h"

namespace knuckle {

/// Gives a skeleton that has no mesh a body: a closed capsule along each bone, as thick as that part of a person is,
/// skinned to the bone whole. Bones must stand in their final place and scale. Bones at the same position as their
/// parent (common in motion capture files) are skinned with the parent. Does nothing for less than two bones.
void addBodyAlongBones(Model& model);

/// Puts the skeleton into the first pose of its first clip where its own rest pose is folded flat (as in mocap files
/// that lay all bones along one axis), standing at the origin, with a note. Only for models without a mesh.
void unfoldRestPose(Model& model);

}  // namespace knuckle
