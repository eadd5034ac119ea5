#include "sim/gpu/device/thread_device.h"

#include <stdexcept>

namespace knuckle {

namespace {

struct ThreadDevice {
    std::weak_ptr<Gpu> gpu;
    std::string name;
};

}  // namespace

std::shared_ptr<Gpu> deviceOfThread(const std::string& name, const FrameWork& work)
{
    thread_local ThreadDevice device;
    if (auto gpu = device.gpu.lock()) {
        if (name != device.name)
            throw std::logic_error("this thread computes on \"" + device.name + "\" already, not on \"" + name + "\"");
        return gpu;
    }
    auto gpu = std::make_shared<Gpu>(DeviceChoice::parse(name), std::string{}, work);
    device = {gpu, name};
    return gpu;
}

}  // namespace knuckle
