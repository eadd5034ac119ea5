#pragma once

#include "sim/actor/model.h"
#include "sim/actor/model_source.h"
#include "sim/world/errors.h"

namespace knuckle {

struct ImportOptions {
    ModelFit fit = {};
    bool clips = true;
    bool surface = false;  ///< Whether it is going to be drawn: only then its textures are read.
    ModelPick pick = {};
};

/// A file has several skeletons and nobody said which, or none of the name that was given.
struct SkeletonError : InputError {
    using InputError::InputError;
};

/// Reads a model with assimp in a child process with limits on memory and time, since libassimp crashes or allocates
/// without bound on some broken files. @throws InputError naming the file, what is wrong and the remedy; SkeletonError
/// without a remedy, which depends on who asks.
Model importModel(const std::string& path, const ImportOptions& options = {});

}  // namespace knuckle
