#pragma once

#include <vector>

#include "sim/rig/anatomy/anatomy.h"

namespace knuckle {

/// Gives limbs of no known part, and levers, their axis if all clips turn them about one axis against their parents,
/// and far enough.
void readClipHinges(const Model& model, std::vector<BoneAnatomy>& anatomy);

}  // namespace knuckle
