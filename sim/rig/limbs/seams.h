#pragma once

#include <vector>

#include "sim/rig/limbs/body_draft.h"
#include "sim/rig/mesh/voxelize.h"

namespace knuckle {

/// Per body, places of particles on a new lattice [m]; none for a body that keeps the grid's.
using LimbPlaces = std::vector<std::vector<Eigen::Vector3f>>;

constexpr float CROWDED = 0.7f;  ///< Of a diameter: if particles of two bodies are nearer than this, one gives way.

/// Removes particles that crowd those of another body, then keeps the grid's particles of the same bodies where the new
/// lattice leaves room: beside other bodies, and in parts too thin for it.
void fitSeams(const std::vector<BodyDraft>& drafts, const Voxels& grid, LimbPlaces& places);

}  // namespace knuckle
