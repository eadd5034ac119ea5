#pragma once

#include "sim/rig/actor.h"
#include "sim/rig/actor_options.h"
#include "sim/rig/figure.h"

namespace knuckle {

/// An actor at the resolution of the options: their diameter, or the one with as many particles as wanted (within 2 %
/// if any diameter has them). By default a model with limbs gets two and a half particles across the thinnest of them,
/// within 800 to 4000 particles in total. `notes` says what is too thin for two. A model that is split into parts gets
/// partBodies().
/// @param figure read with rolesWanted() of the options. @throws InputError as articulate() does, std::logic_error for
/// more particles than the limit.
Actor makeActor(const Figure& figure, const ActorOptions& options);
/// The same, for a model whose figure is not needed otherwise. @throws also InputError for an override that names no
/// bone of the model.
Actor makeActor(const Model& model, const ActorOptions& options);

}  // namespace knuckle
