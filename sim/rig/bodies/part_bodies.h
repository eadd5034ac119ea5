#pragma once

#include "sim/rig/actor.h"
#include "sim/rig/actor_options.h"
#include "sim/rig/mesh/solid.h"
#include "sim/rig/model.h"

namespace knuckle {

/// Fills a model that was split into parts (Model::isSplit) with particles: each part is a body, without a joint, of
/// the particles in it or nearest to its surface. All are on one lattice, so parts that touch do not overlap. If all
/// are convex polyhedra and not just boxes, each is filled by itself, to flat facets (mesh/polyhedron.h). A part of
/// less than a dozen particles joins the nearest larger one; `notes` says which.
/// @throws InputError as voxelize() does.
Actor partBodies(const Model& model, const Solid& solid, const ActorOptions& options);

}  // namespace knuckle
