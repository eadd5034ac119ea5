#pragma once

#include <vector>

#include "sim/rig/limbs/body_draft.h"
#include "sim/rig/mesh/voxelize.h"

namespace knuckle {

/// Per body, where the particles of a new lattice stand [m]; none for a body that keeps the grid's.
using LimbPlaces = std::vector<std::vector<Eigen::Vector3f>>;

constexpr float CROWDED = 0.7f;  ///< Of a diameter: of two bodies' particles nearer than this one gives way.

/// Takes those away that crowd another body's particles, then keeps what the grid had of the same bodies where the new
/// lattice leaves room for it: beside other bodies, and in parts too thin for it.
void fitSeams(const std::vector<BodyDraft>& drafts, const Voxels& grid, LimbPlaces& places);

}  // namespace knuckle
