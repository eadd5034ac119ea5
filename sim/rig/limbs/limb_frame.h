#pragma once

#include <optional>

#include "sim/rig/limbs/body_draft.h"
#include "sim/rig/limbs/limb_lattice.h"
#include "sim/rig/mesh/voxelize.h"

namespace knuckle {

/// Unit, across a limb: where the figure looks, or up for a limb that points there.
Eigen::Vector3f acrossLimb(const Eigen::Vector3f& along, const Eigen::Vector3f& forward);

/// How a body's lattice stands: from its joint to the farthest of those on it; where there is none along its bone, or
/// through its middle; nothing for one that is not slender.
/// @param boneEnd of its bone, where it has one.
std::optional<LimbFrame> limbFrame(const std::vector<BodyDraft>& drafts, uint32_t body, const Voxels& voxels,
                                   const Eigen::Vector3f& forward, const std::optional<Eigen::Vector3f>& boneEnd);

/// The part of v across `along`, as unit vectors; any across it where v has none.
Eigen::Vector3f perpendicular(const Eigen::Vector3f& v, const Eigen::Vector3f& along);

}  // namespace knuckle
