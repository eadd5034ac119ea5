#pragma once

#include "sim/rig/actor.h"
#include "sim/rig/actor_options.h"
#include "sim/rig/model.h"

namespace knuckle {

/// The bodies of an actor, for one of the same model at another resolution: it gets the same, with the same numbers.
BodyPlan planOf(const Actor& actor, const Model& model);

/// The difference between the bodies and joints of two actors of a model, a sentence; empty if they have the same
/// names, types and connections.
std::string differenceOf(const Actor& first, const Actor& other);

}  // namespace knuckle
