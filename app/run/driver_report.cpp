#include "app/run/driver_report.h"

#include <fmt/format.h>

#include "sim/base/cores.h"
#include "sim/gpu/device/driver_threads.h"

namespace knuckle {

std::string threadsText()
{
    if (const std::string set = driverThreadsSetting(); !set.empty())
        return fmt::format("{} ({} is set)", set, DRIVER_THREADS_VARIABLE);
    const uint32_t cores = usableCores();
    if (cores == 1) return "none: there is one core";
    return fmt::format("{} or none, what is faster for the scene (see --stats); waking them takes {:.3f} ms a pass",
                       cores, wakeTime(cores));
}

}  // namespace knuckle
