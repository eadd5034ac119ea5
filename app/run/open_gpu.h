#pragma once

#include <memory>
#include <optional>
#include <string>

#include "sim/base/errors.h"
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

/// Looks for a device. @throws DeviceError that points to the command which says more.
template <typename Work>
auto withPointer(Work work)
{
    try {
        return work();
    } catch (const DeviceError& error) {
        throw DeviceError(std::string(error.what()) + "; `knuckle doctor` says more");
    }
}

}  // namespace knuckle
