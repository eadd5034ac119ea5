#pragma once

#include <optional>

#include "sim/rig/limbs/body_draft.h"
#include "sim/rig/limbs/limb_lattice.h"
#include "sim/rig/mesh/voxelize.h"

namespace knuckle {

/// Unit, across a limb: the direction that the figure faces, or up for a limb that points there.
Eigen::Vector3f acrossLimb(const Eigen::Vector3f& along, const Eigen::Vector3f& forward);

/// Frame of a body's lattice: from its joint to the farthest of the joints on it; without those, along its bone, or
/// through its middle; nothing for a body that is not slender.
/// @param boneEnd of its bone, if it has one.
std::optional<LimbFrame> limbFrame(const std::vector<BodyDraft>& drafts, uint32_t body, const Voxels& voxels,
                                   const Eigen::Vector3f& forward, const std::optional<Eigen::Vector3f>& boneEnd);

/// The part of v across `along`, as a unit vector; any direction across it if v has none.
Eigen::Vector3f perpendicular(const Eigen::Vector3f& v, const Eigen::Vector3f& along);

}  // namespace knuckle
