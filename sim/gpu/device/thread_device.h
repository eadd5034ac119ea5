#pragma once

#include <memory>
#include <string>

#include "sim/gpu/gpu.h"

namespace knuckle {

/// The one device of this thread: two contexts would take it from each other. It lives while anyone holds it.
/// @param name as `--device`. @param work of a frame of the first who asks, see Gpu.
/// @throws DeviceError, InputError as Gpu; std::logic_error for another name than that of the device that is there.
std::shared_ptr<Gpu> deviceOfThread(const std::string& name, const FrameWork& work);

}  // namespace knuckle
