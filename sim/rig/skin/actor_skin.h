#pragma once

#include "sim/rig/actor.h"
#include "sim/rig/model.h"

namespace knuckle {

/// The mesh of an actor's own model with its bodies' weights, and those of the particles: what the skin has at the
/// point nearest to each. Empty for a model without triangles.
/// @throws InputError as bodiesOfBones().
ActorSkin makeActorSkin(const Actor& actor, const Model& model);

}  // namespace knuckle
