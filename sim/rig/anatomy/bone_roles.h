#pragma once

#include <map>
#include <vector>

#include "sim/rig/anatomy/anatomy.h"
#include "sim/rig/anatomy/bone_tree.h"
#include "sim/rig/anatomy/names/bone_name.h"

namespace knuckle {

/// Fills role, owner and parent of bones whose parts are known. @param wanted roles that are given.
void readRoles(const BoneTree& tree, const std::vector<BoneName>& names, const std::map<uint32_t, BoneRole>& wanted,
               std::vector<BoneAnatomy>& anatomy);

}  // namespace knuckle
