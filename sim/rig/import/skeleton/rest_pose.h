#pragma once

#include <vector>

#include "sim/rig/anatomy/anatomy.h"
#include "sim/rig/model.h"

namespace knuckle {

/// If a skeleton's own rest pose is not one (as in motion capture files that lay all bones along one axis), puts the
/// skeleton into the first proper pose of its clips, standing at the origin, with a note. In a pose, a body has its
/// head over its feet and its left side apart from its right; anything else is not flat. Only for models without a
/// mesh.
/// @param anatomy of its bones, one each.
/// @returns whether it was moved. @throws InputError for a cloud of markers, which is no skeleton.
bool chooseRestPose(Model& model, const std::vector<BoneAnatomy>& anatomy);

}  // namespace knuckle
