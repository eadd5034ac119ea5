#pragma once

#include <string>

#include "sim/actor/model.h"

namespace knuckle {

/// That a file may be a model, and that the files which it names and needs are there and whole.
/// @throws InputError saying what is not, and what to do.
void checkParts(const std::string& path);

/// What to say of a file that assimp could not read, for a reason that it gave.
std::string unreadableBecause(const std::string& reason);

/// Notes which material files of an .obj are not there.
void noteMissingMaterials(const std::string& path, ModelSurface& surface);

}  // namespace knuckle
