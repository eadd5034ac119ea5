#include "app/run/open_gpu.h"

#include "app/run/tell.h"

namespace knuckle {

std::unique_ptr<Gpu> openGpu(const CommonOptions& common, std::optional<FrameWork> work)
{
    auto gpu = withPointer(
        [&] { return std::make_unique<Gpu>(DeviceChoice::parse(common.device), common.shaderFolder, work); });
    if (!gpu->notice().empty() && !common.quiet) tellUser(gpu->notice());
    return gpu;
}

}  // namespace knuckle
