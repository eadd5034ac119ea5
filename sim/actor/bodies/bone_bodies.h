#pragma once

#include <span>
#include <string>
#include <vector>

#include "sim/actor/anatomy/anatomy.h"
#include "sim/actor/limbs/body_draft.h"
#include "sim/actor/limbs/mirror.h"
#include "sim/actor/model.h"

namespace knuckle {

/// Cuts the particles into one body per limb that is large enough, arranged as a tree with one root. `notes` gets a
/// sentence for whatever was joined elsewhere than the skeleton says.
/// @param anatomy of the model's bones, one each.
/// @param mirror null for a model without symmetry; else both sides are cut alike, and may get or lose particles.
/// @param forward where the figure looks, level and unit.
std::vector<BodyDraft> cutIntoBodies(const Model& model, const Solid& solid, std::span<const BoneAnatomy> anatomy,
                                     const Mirror* mirror, const Eigen::Vector3f& forward, Voxels& voxels,
                                     std::vector<std::string>& notes);

}  // namespace knuckle
