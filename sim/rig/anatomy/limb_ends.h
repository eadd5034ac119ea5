#pragma once

#include <span>
#include <vector>

#include "sim/rig/anatomy/anatomy.h"
#include "sim/rig/anatomy/bone_tree.h"
#include "sim/rig/anatomy/names/bone_name.h"

namespace knuckle {

/// The limb that a foot, a hand, a toe, a finger or the lower half of a limb belongs to, which hangs on something else:
/// of its side and kind the one whose name says the same besides ("front", numbers), of such the one that has none yet,
/// of these the one at whose end it is. Feet go on front legs as well. A leaf of one side that nobody names goes on a
/// limb only where it is at its end.
/// @param hasBody per bone: whether the limb has skin. @param part what the end is looked at as; Other: nobody names
/// it. @returns -1 for none.
int32_t limbOfEnd(const BoneTree& tree, const std::vector<BoneName>& names, const std::vector<BoneAnatomy>& anatomy,
                  std::span<const uint8_t> hasBody, uint32_t end, BodyPart part);

}  // namespace knuckle
