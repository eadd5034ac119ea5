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
    std::vector<uint32_t> levels;  ///< Numbers of particles, of which each makes an actor.
    uint32_t jobs = 1;
    ModelFit fit;
    std::string up = "y";
    bool center = false;
    bool grid = false, split = false, skin = false;
};

/// What is written of a model, if named, at one resolution.
struct VoxelizeFiles {
    std::string actor, preview;
    uint32_t particles = 0;  ///< 0: the diameter of the options decides, or the model.
};

/// Makes an actor for each, of which the first, the coarsest, decides which bones have bodies; prints the table of that
/// if asked to, and writes what is named. Several threads may do so at once.
/// @throws InputError, DeviceError, RunError; nothing is written then.
std::vector<Actor> voxelizeModel(const std::string& path, const std::vector<VoxelizeFiles>& levels,
                                 const VoxelizeOptions& options, const CommonOptions& common, bool prints);

}  // namespace knuckle
