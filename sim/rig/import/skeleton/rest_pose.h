#pragma once

#include <vector>

#include "sim/rig/anatomy/anatomy.h"
#include "sim/rig/model.h"

namespace knuckle {

/// Puts a skeleton whose own rest pose is none (as in files of motion capture that lay all bones along one axis) into
/// the first pose of its clips that is one, standing at the origin, with a note. A pose of a body has its head over its
/// feet and its left side apart from its right one; of anything else it is not flat. Only for models without a mesh.
/// @param anatomy of its bones, one each.
/// @returns whether it was moved. @throws InputError for a cloud of markers, which is no skeleton.
bool chooseRestPose(Model& model, const std::vector<BoneAnatomy>& anatomy);

}  // namespace knuckle
