#include "sim/gpu/device/driver_advice.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstdlib>
#include <vector>

#include "sim/base/errors.h"
#include "sim/base/memory.h"

namespace knuckle {

std::string driverVariables()
{
    std::vector<std::string> set;
    for (const char* name : {"MESA_GL_VERSION_OVERRIDE", "MESA_GLSL_VERSION_OVERRIDE", "MESA_EXTENSION_OVERRIDE",
                             "GALLIUM_DRIVER", "MESA_LOADER_DRIVER_OVERRIDE", "LIBGL_DRIVERS_PATH",
                             "LIBGL_ALWAYS_SOFTWARE", "EGL_PLATFORM", "__EGL_VENDOR_LIBRARY_FILENAMES",
                             "__EGL_VENDOR_LIBRARY_DIRS", "GBM_BACKENDS_PATH", "VK_ICD_FILENAMES", "VK_DRIVER_FILES"})
        if (const char* value = std::getenv(name)) set.push_back(fmt::format("{}={}", name, value));
    return fmt::format("{}", fmt::join(set, " and "));
}

void failOnDevice(const std::string& message, const std::string& remedy)
{
    if (isMemoryShort()) throw RunError(memoryMessage());
    const std::string variables = driverVariables();
    if (!variables.empty())
        throw DeviceError(fmt::format("{}; the environment has {}: unset that", message, variables));
    throw DeviceError(message + (remedy.empty() ? "" : "; " + remedy));
}

}  // namespace knuckle
