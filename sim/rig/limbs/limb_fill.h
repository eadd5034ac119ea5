#pragma once

#include <vector>

#include "sim/rig/figure.h"
#include "sim/rig/limbs/body_draft.h"
#include "sim/rig/mesh/voxelize.h"

namespace knuckle {

/// Refills long limbs, each on its own lattice along its bone, if that is nearer to the skin than the grid that they
/// were cut from; feet, trunk and head stay on the grid. Limbs that are images of each other get mirrored particles.
void fillAlongBones(const Figure& figure, const Solid& solid, std::vector<BodyDraft>& drafts, Voxels& voxels);

}  // namespace knuckle
