#pragma once

#include <string>
#include <vector>

#include "app/run/open_gpu.h"
#include "sim/rig/actor.h"

namespace knuckle {

/// Options of `knuckle voxelize`.
struct VoxelizeOptions {
    std::vector<std::string> models;
    std::string output, joints, preview, skeleton;
    std::vector<std::string> keep, merge;
    double diameter = 0.0;
    uint32_t particles = 0;
    ModelFit fit;
    std::string up = "y";
    bool center = false;
    bool grid = false, split = false, skin = false;
};

/// A model and what is written of it, if named.
struct VoxelizeFiles {
    std::string model, actor, preview;
};

/// Makes an actor, prints its table if asked to, and writes what is named. @throws InputError, DeviceError, RunError.
Actor voxelizeModel(const VoxelizeFiles& files, const VoxelizeOptions& options, const CommonOptions& common,
                    bool prints);

}  // namespace knuckle
