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

/// The device that `--device` names; says on stderr what had to be chosen instead. @throws DeviceError, InputError.
/// @param work of a frame, by which a software renderer gets its threads, else they are left to it.
std::unique_ptr<Gpu> openGpu(const CommonOptions& common, std::optional<FrameWork> work = {});

}  // namespace knuckle
