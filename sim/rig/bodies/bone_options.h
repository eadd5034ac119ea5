#pragma once

#include <map>

#include "sim/rig/actor_options.h"
#include "sim/rig/anatomy/anatomy.h"
#include "sim/rig/model.h"

namespace knuckle {

/// @throws InputError for a name or pattern that fits no bone of the model.
void checkBoneNames(const Model& model, const ArticulationOptions& options);

/// What the options want bones to be, by index: those of `keep` limbs, those of `merge` attached.
std::map<uint32_t, BoneRole> rolesWanted(const Model& model, const ArticulationOptions& options);

}  // namespace knuckle
