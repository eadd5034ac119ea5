#pragma once

#include <string>

#include "sim/actor/import/model.h"

namespace knuckle {

/// The model as a binary glTF 2.0 file: one skinned mesh, its skeleton, its clips (linear keys). Bones must be rigid
/// poses; at most four weights a vertex and 256 bones are kept. The same model gives the same bytes.
std::string toGlb(const Model& model);

}  // namespace knuckle
