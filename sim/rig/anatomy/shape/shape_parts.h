#pragma once

#include <vector>

#include "sim/rig/anatomy/anatomy.h"
#include "sim/rig/anatomy/bone_tree.h"

namespace knuckle {

/// Part, side and source from the skeleton's shape alone, if it has legs: pairs of chains that mirror each other and
/// end at the ground. One pair of legs makes a figure, whose pair above are arms; more make a creature.
/// @param named parts from names: which bone of a limb is which part, as far as known, and which side is the left.
std::vector<BoneAnatomy> readShape(const BoneTree& tree, const std::vector<BoneAnatomy>& named);

}  // namespace knuckle
