#pragma once

#include <vector>

#include "sim/rig/anatomy/anatomy.h"
#include "sim/rig/anatomy/bone_tree.h"
#include "sim/rig/anatomy/names/bone_name.h"

namespace knuckle {

/// Part, side and source by names; what these leave open of limbs, a knee or a whole arm, by the skeleton's shape: only
/// for bones whose names say nothing, and only if the shape agrees with the names of the others.
/// @param names get the sides of limbs that are named without one.
std::vector<BoneAnatomy> readParts(const BoneTree& tree, std::vector<BoneName>& names);

}  // namespace knuckle
