#pragma once

#include <vector>

#include "sim/rig/anatomy/anatomy.h"
#include "sim/rig/anatomy/bone_tree.h"
#include "sim/rig/anatomy/names/bone_name.h"

namespace knuckle {

/// Fills part, side and source of bones whose names say something. If a name may mean several things, the bones above
/// and below decide: a hip above a knee is a thigh, above a thigh nothing of its own; a leg below an upper leg is a
/// shin; a shoulder above an upper arm is a collar bone, above an elbow the upper arm.
void readNamedParts(const BoneTree& tree, const std::vector<BoneName>& names, std::vector<BoneAnatomy>& anatomy);

/// The part of an arm for a part of a front leg of four; other parts stay what they are.
BodyPart ofForeLeg(BodyPart part);

/// Whether a part belongs to an arm or a leg.
bool isLimbPart(BodyPart part);

}  // namespace knuckle
