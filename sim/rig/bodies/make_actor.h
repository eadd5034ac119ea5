#pragma once

#include "sim/rig/actor.h"
#include "sim/rig/actor_options.h"
#include "sim/rig/figure.h"

namespace knuckle {

/// An actor at the resolution that the options ask for: their diameter, or the one with as many particles as wanted
/// (within 2 % where any diameter has them), or by default of a model with limbs two and a half particles across the
/// thinnest of them, as far as that is 800 to 4000 particles. `notes` says what is too thin for two. Of a model that
/// is split into parts it is partBodies().
/// @param figure read with rolesWanted() of the options. @throws InputError as articulate() does, std::logic_error for
/// more particles than the limit.
Actor makeActor(const Figure& figure, const ActorOptions& options);
/// The same, of a model of which nobody else needs the figure. @throws also InputError for an override that names no
/// bone of the model.
Actor makeActor(const Model& model, const ActorOptions& options);

}  // namespace knuckle
