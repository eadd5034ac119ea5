#pragma once

#include <vector>

#include "sim/actor/anatomy/anatomy.h"
#include "sim/actor/anatomy/bone_name.h"
#include "sim/actor/anatomy/bone_tree.h"

namespace knuckle {

/// Fills the parents of limbs, whose parts, roles and owners are known: what their bones hang on, or where these hang
/// on nothing of the body, what their part of a body does.
void readParents(const BoneTree& tree, const std::vector<BoneName>& names, std::vector<BoneAnatomy>& anatomy);

}  // namespace knuckle
