#pragma once

#include "sim/actor/anatomy/anatomy.h"
#include "sim/actor/anatomy/bone_tree.h"

namespace knuckle {

/// Fills part, side and source from the skeleton's shape, where it has legs: pairs of chains that mirror each other
/// and end at the ground. One pair of legs makes a figure, whose pair above has arms; more make a creature. Bones that
/// have a part keep it, and so do sides that names say.
void readPartsFromShape(const BoneTree& tree, std::vector<BoneAnatomy>& anatomy);

}  // namespace knuckle
