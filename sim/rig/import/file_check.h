#pragma once

#include <string>

#include "sim/rig/model.h"

namespace knuckle {

/// That a file may be a model, and that the files which it names and needs are there and whole.
/// @throws InputError saying what is not, and what to do.
void checkParts(const std::string& path);

/// Of a file of which no body can be made.
inline constexpr const char* NO_MESH = "it holds neither triangles nor a skeleton: export a mesh";

/// What to say of a file that assimp could not read, for a reason that it gave.
std::string unreadableBecause(const std::string& reason);

/// Tells which material files of an .obj are not there.
void noteMissingMaterials(const std::string& path, ModelSurface& surface);

}  // namespace knuckle
