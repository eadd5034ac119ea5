#pragma once

#include <vector>

#include "sim/rig/anatomy/anatomy.h"
#include "sim/rig/model.h"

namespace knuckle {

/// Gives a skeleton without a mesh a body: a closed capsule along each bone, as thick as that part of a person, skinned
/// to this bone only. Bones from a scene's root to the hips get none. Bones must be in their final place and scale.
/// Bones at the same position as their parent (common in motion capture files) are skinned with the parent. A head, a
/// hand or a foot without children is as long as a person's. Does nothing for less than two bones. @param anatomy of
/// its bones, one each.
void addBodyAlongBones(Model& model, const std::vector<BoneAnatomy>& anatomy);

}  // namespace knuckle
