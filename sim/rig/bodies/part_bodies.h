#pragma once

#include "sim/rig/actor.h"
#include "sim/rig/actor_options.h"
#include "sim/rig/mesh/solid.h"
#include "sim/rig/model.h"

namespace knuckle {

/// Fills a model that was split into parts (Model::isSplit) with particles: each part is a body of those that are in it
/// or nearest to its surface, without a joint. All stand on one lattice, so parts that touch do not overlap. A part of
/// less than a dozen particles belongs to the nearest larger one; `notes` says which.
/// @throws InputError as voxelize() does.
Actor partBodies(const Model& model, const Solid& solid, const ActorOptions& options);

}  // namespace knuckle
