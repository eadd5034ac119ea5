#pragma once

#include "sim/rig/import/skeleton_error.h"
#include "sim/rig/model.h"
#include "sim/rig/model_source.h"

namespace knuckle {

struct ImportOptions {
    ModelFit fit = {};
    bool clips = true;
    bool surface = false;  ///< Whether it will be drawn: only then are its textures read.
    ModelPick pick = {};
};

/// Reads a model with assimp in a child process with limits on memory and time, since libassimp crashes or allocates
/// without bound on some broken files. @throws InputError with the file, the defect and the remedy; SkeletonError
/// without a remedy, which depends on the caller.
Model importModel(const std::string& path, const ImportOptions& options = {});

}  // namespace knuckle
