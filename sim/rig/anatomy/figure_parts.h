#pragma once

#include <vector>

#include "sim/rig/anatomy/anatomy.h"
#include "sim/rig/anatomy/bone_tree.h"
#include "sim/rig/anatomy/names/bone_name.h"

namespace knuckle {

/// Corrects and completes the parts from names with what only the whole figure tells: levers of machines, feet and
/// hands that end numbered limbs, front legs of four, hips and head if no bone is called so.
void readFigure(const BoneTree& tree, const std::vector<BoneName>& names, std::vector<BoneAnatomy>& anatomy);

/// The part of the nearest bone above that has a part and is of the same side; Other for none.
BodyPart partAbove(const BoneTree& tree, const std::vector<BoneAnatomy>& anatomy, uint32_t bone);

/// The bone of the spine for an arm that hangs on none: the nearest of those that begin below the arm, else the nearest
/// of all; -1 for none.
int32_t spineAt(const BoneTree& tree, const std::vector<BoneAnatomy>& anatomy, uint32_t arm);

}  // namespace knuckle
