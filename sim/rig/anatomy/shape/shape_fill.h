#pragma once

#include <vector>

#include "sim/rig/anatomy/anatomy.h"
#include "sim/rig/anatomy/bone_tree.h"
#include "sim/rig/anatomy/names/bone_name.h"

namespace knuckle {

/// Part, side and source by names; what these leave open of limbs, a knee or a whole arm, by the skeleton's shape, for
/// bones that names say nothing of, and only where it says of the others what names do.
/// @param names get the sides of limbs that they name without one.
std::vector<BoneAnatomy> readParts(const BoneTree& tree, std::vector<BoneName>& names);

}  // namespace knuckle
