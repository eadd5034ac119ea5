#pragma once

#include <vector>

#include "sim/rig/anatomy/anatomy.h"
#include "sim/rig/anatomy/bone_tree.h"

namespace knuckle {

/// Part, side and source from the skeleton's shape alone, where it has legs: pairs of chains that mirror each other and
/// end at the ground. One pair of legs makes a figure, whose pair above has arms; more make a creature.
/// @param named what names say: which bone of a limb is which part, where they know one, and which side is the left.
std::vector<BoneAnatomy> readShape(const BoneTree& tree, const std::vector<BoneAnatomy>& named);

}  // namespace knuckle
