#pragma once

#include <string>

#include "sim/actor/actor.h"
#include "sim/actor/import/model.h"

namespace knuckle {

/// What `knuckle voxelize` prints: a line for each body with the bones in it, its particles, its joint to the parent;
/// totals; and what was merged, dropped or assumed.
std::string actorTable(const Actor& actor);

/// A line for each clip: its name and length.
std::string clipTable(const Model& model);

}  // namespace knuckle
