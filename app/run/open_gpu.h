#pragma once

#include <memory>
#include <optional>
#include <string>

#include "sim/gpu/gpu.h"

namespace knuckle {

/// Options that every command takes.
struct CommonOptions {
    std::string device = "auto";
    std::string shaderFolder;
    bool quiet = false;
};

/// The device that `--device` names; prints to stderr if it had to choose another. @throws DeviceError, InputError.
/// @param work of a frame, which determines a software renderer's threads; without it the renderer chooses.
std::unique_ptr<Gpu> openGpu(const CommonOptions& common, std::optional<FrameWork> work = {});

}  // namespace knuckle
