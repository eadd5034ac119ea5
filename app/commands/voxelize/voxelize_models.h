#pragma once

#include "app/commands/voxelize/voxelize_model.h"

namespace knuckle {

/// One model into a file, with its table; or several, and those of folders, into folders, with a line for each: what
/// fails does not keep the others back. @returns the exit code: of several that of the first failure.
/// @throws InputError for options that make no sense together.
int voxelizeModels(const VoxelizeOptions& options, const CommonOptions& common);

/// The endings of files of a folder that are read as models.
std::string modelEndings();

}  // namespace knuckle
