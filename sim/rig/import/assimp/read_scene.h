#pragma once

#include <string>

#include "sim/rig/model.h"
#include "sim/rig/model_source.h"

namespace knuckle {

/// Reads and converts a file, in the file's own units. @param surface see ImportOptions. @throws InputError.
Model readScene(const std::string& path, bool surface, const ModelPick& pick);

}  // namespace knuckle
