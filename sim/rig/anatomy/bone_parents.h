#pragma once

#include <vector>

#include "sim/rig/anatomy/anatomy.h"
#include "sim/rig/anatomy/bone_tree.h"
#include "sim/rig/anatomy/names/bone_name.h"

namespace knuckle {

/// Fills the parents of limbs, whose parts, roles and owners are known: the limbs that their bones hang on, or if these
/// hang on nothing of the body, those that their part of a body hangs on.
void readParents(const BoneTree& tree, const std::vector<BoneName>& names, std::vector<BoneAnatomy>& anatomy);

}  // namespace knuckle
