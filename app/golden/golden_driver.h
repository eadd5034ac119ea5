#pragma once

#include <string>

#include "app/golden/golden_file.h"
#include "sim/gpu/gpu.h"

namespace knuckle {

/// A short name of a device, for names of files: "llvmpipe", "zink-llvmpipe", "nvidia-h100-pcie".
/// @param device GL_RENDERER.
std::string driverKey(const std::string& device);

/// Whether references were made by this device and driver. The width of llvmpipe's vectors does not count: bits do not
/// depend on it.
bool isOwn(const GoldenRecord& record, const DeviceInfo& device);

/// The references that a device is compared with.
struct ChosenReference {
    std::string key;
    bool own = true;  ///< Otherwise they are those of the nearest driver.
};

/// Its own references, else those with a name that begins as its own does, as far as possible.
/// @throws InputError for a golden without any.
ChosenReference chooseReference(const Golden& golden, const DeviceInfo& device);

/// A name under which new references of a device stand beside those of others: driverKey(), with the driver's version
/// where another version has that name.
std::string newKey(const Golden& golden, const DeviceInfo& device);

}  // namespace knuckle
