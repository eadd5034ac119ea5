#pragma once

#include <vector>

#include "sim/rig/anatomy/anatomy.h"
#include "sim/rig/model.h"

namespace knuckle {

/// Gives a skeleton that has no mesh a body: a closed capsule along each bone, as thick as that part of a person is,
/// skinned to the bone whole. What leads from a scene's root to the hips gets none. Bones must stand in their final
/// place and scale. Bones at the same position as their parent (common in motion capture files) are skinned with the
/// parent. A head, a hand or a foot on which no bone hangs is as long as a person's. Does nothing for less than two
/// bones. @param anatomy of its bones, one each.
void addBodyAlongBones(Model& model, const std::vector<BoneAnatomy>& anatomy);

}  // namespace knuckle
