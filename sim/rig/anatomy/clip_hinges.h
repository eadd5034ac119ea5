#pragma once

#include <vector>

#include "sim/rig/anatomy/anatomy.h"

namespace knuckle {

/// Limbs of no known part, and levers, that all clips turn about one axis against what they hang on, and by much, get
/// that axis.
void readClipHinges(const Model& model, std::vector<BoneAnatomy>& anatomy);

}  // namespace knuckle
