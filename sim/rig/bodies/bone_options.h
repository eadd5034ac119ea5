#pragma once

#include <map>

#include "sim/rig/actor_options.h"
#include "sim/rig/anatomy/anatomy.h"
#include "sim/rig/model.h"

namespace knuckle {

/// @throws InputError for a name or pattern that matches no bone of the model.
void checkBoneNames(const Model& model, const ArticulationOptions& options);

/// Roles of bones by the options, by index: limbs for those of `keep`, attached for those of `merge`.
std::map<uint32_t, BoneRole> rolesWanted(const Model& model, const ArticulationOptions& options);

}  // namespace knuckle
