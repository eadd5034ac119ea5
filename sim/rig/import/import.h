#pragma once

#include "sim/rig/import/skeleton_error.h"
#include "sim/rig/model.h"
#include "sim/rig/model_source.h"

namespace knuckle {

struct ImportOptions {
    ModelFit fit = {};
    bool clips = true;
    bool surface = false;  ///< Whether it is going to be drawn: only then its textures are read.
    ModelPick pick = {};
};

/// Reads a model with assimp in a child process with limits on memory and time, since libassimp crashes or allocates
/// without bound on some broken files. @throws InputError naming the file, what is wrong and the remedy; SkeletonError
/// without a remedy, which depends on who asks.
Model importModel(const std::string& path, const ImportOptions& options = {});

}  // namespace knuckle
