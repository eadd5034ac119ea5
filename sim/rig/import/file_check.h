#pragma once

#include <string>

#include "sim/rig/model.h"

namespace knuckle {

/// Checks that a file may be a model, and that the files that it needs exist and are whole.
/// @throws InputError with the defect and the remedy.
void checkParts(const std::string& path);

/// For a file that no body can be made of.
inline constexpr const char* NO_MESH = "it holds neither triangles nor a skeleton: export a mesh";

/// The message for a file that assimp could not read, by assimp's reason.
std::string unreadableBecause(const std::string& reason);

/// Notes which material files of an .obj are missing.
void noteMissingMaterials(const std::string& path, ModelSurface& surface);

}  // namespace knuckle
