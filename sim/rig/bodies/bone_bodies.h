#pragma once

#include <string>
#include <vector>

#include "sim/rig/actor_options.h"
#include "sim/rig/figure.h"
#include "sim/rig/limbs/body_draft.h"
#include "sim/rig/mesh/voxelize.h"

namespace knuckle {

/// Cuts the particles into one body per limb that is large enough, arranged as a tree with one root. `notes` gets a
/// sentence for each body that joins elsewhere than its bone. Both sides of a symmetric figure are cut alike, which may
/// add or remove particles.
/// @param plan of bodies instead, unless it is empty.
std::vector<BodyDraft> cutIntoBodies(const Figure& figure, const Solid& solid, Voxels& voxels, const BodyPlan& plan,
                                     std::vector<std::string>& notes);

}  // namespace knuckle
