#pragma once

#include <span>
#include <vector>

#include "sim/rig/anatomy/anatomy.h"
#include "sim/rig/anatomy/bone_tree.h"
#include "sim/rig/anatomy/names/bone_name.h"

namespace knuckle {

/// The limb for a foot, a hand, a toe, a finger or the lower half of a limb that hangs on something else: among those
/// of its side and kind the one whose name has the same words ("front", numbers), among these one that has no such end
/// yet, then the one whose end is nearest. Feet also go on front legs. An unnamed leaf of one side goes on a limb only
/// if it is at the limb's end.
/// @param hasBody per bone: whether the limb has skin. @param part that the end is taken for; Other: it has no name.
/// @returns -1 for none.
int32_t limbOfEnd(const BoneTree& tree, const std::vector<BoneName>& names, const std::vector<BoneAnatomy>& anatomy,
                  std::span<const uint8_t> hasBody, uint32_t end, BodyPart part);

}  // namespace knuckle
