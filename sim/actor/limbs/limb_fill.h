#pragma once

#include <span>

#include "sim/actor/anatomy/anatomy.h"
#include "sim/actor/limbs/body_draft.h"
#include "sim/actor/limbs/mirror.h"

namespace knuckle {

/// Fills long limbs anew, each on a lattice of its own along its bone, where that is nearer to the skin than the grid
/// that they were cut from; feet, trunk and head stay on the grid. Limbs that are images of each other get
/// images of the same particles.
/// @param forward where the figure looks, level and unit: rows of particles go across it.
/// @param mirror null for a skeleton without symmetry.
void fillAlongBones(const Model& model, const Solid& solid, std::span<const BoneAnatomy> anatomy,
                    const Eigen::Vector3f& forward, const Mirror* mirror, std::vector<BodyDraft>& drafts,
                    Voxels& voxels);

}  // namespace knuckle
