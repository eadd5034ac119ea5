#pragma once

#include "sim/rig/actor.h"
#include "sim/rig/actor_options.h"
#include "sim/rig/figure.h"

namespace knuckle {

/// Fills the model with particles and cuts it into bodies that share particles at the joints.
///
/// Each particle belongs to the limb that weighs most at the nearest point of the skin, together with the twists and
/// attached bones of that (readAnatomy()). A limb with fewer than four particles, or with coplanar ones, joins the body
/// that it hangs on. Every body except the first has one joint, with an earlier body; the joints form a tree. Particles
/// of a joint: ball one, hinge two or more on its axis, stiff four, universal a flat body of five (named after the bone
/// with "/cross" added) that shares two with each side, so it counts as two joints of type Universal in a row. A model
/// without bones becomes one body without joints.
/// @param solid of the model's mesh.
/// @throws InputError as voxelize() does, and for an override that names no bone of the model.
Actor articulate(const Figure& figure, const Solid& solid, const ActorOptions& options);

}  // namespace knuckle
