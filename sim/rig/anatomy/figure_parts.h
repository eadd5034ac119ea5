#pragma once

#include <vector>

#include "sim/rig/anatomy/anatomy.h"
#include "sim/rig/anatomy/bone_tree.h"
#include "sim/rig/anatomy/names/bone_name.h"

namespace knuckle {

/// Corrects and completes parts that names say by what only the whole figure tells: levers of machines, feet and hands
/// that end numbered limbs, front legs of four, hips and head where nothing is called so.
void readFigure(const BoneTree& tree, const std::vector<BoneName>& names, std::vector<BoneAnatomy>& anatomy);

/// The part of the nearest bone above that has one and is of the same side; Other for none.
BodyPart partAbove(const BoneTree& tree, const std::vector<BoneAnatomy>& anatomy, uint32_t bone);

/// The spine's bone to which an arm belongs that hangs on none: of those that begin below the arm the nearest, else the
/// nearest of all; -1 for none.
int32_t spineAt(const BoneTree& tree, const std::vector<BoneAnatomy>& anatomy, uint32_t arm);

}  // namespace knuckle
