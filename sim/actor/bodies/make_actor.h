#pragma once

#include "sim/actor/bodies/articulate.h"

namespace knuckle {

/// An actor at the resolution that the options ask for: their diameter, or the one with as many particles as wanted
/// (within 2 % where any diameter has them), or by default of a model with limbs two and a half particles across the
/// thinnest of them, as far as that is 800 to 4000 particles. `notes` says what is too thin for two. Of a model that
/// is split into parts it is partBodies().
/// @throws InputError and std::logic_error as articulate() does.
Actor makeActor(const Model& model, const ActorOptions& options);

}  // namespace knuckle
