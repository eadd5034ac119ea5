#include "sim/gpu/device/libraries.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include "sim/gpu/device/driver_advice.h"

namespace knuckle {

std::string loadProblem(const std::vector<std::string>& libraries)
{
    std::string problem;
    for (const std::string& library : libraries) {
        if (dlopen(library.c_str(), RTLD_LAZY | RTLD_LOCAL) != nullptr) return {};
        const char* error = dlerror();
        problem += (problem.empty() ? "" : "; ") + std::string(error != nullptr ? error : library.c_str());
    }
    return problem;
}

void requireLibraries()
{
    const auto require = [](const std::vector<std::string>& libraries, const char* remedy) {
        const std::string problem = loadProblem(libraries);
        if (!problem.empty()) failOnDevice(fmt::format("library {}: {}", libraries[0], problem), remedy);
    };
    require({"libEGL.so.1"}, "install libegl1 and libgl1-mesa-dri (Mesa), or the vendor's driver");
    require(OPENGL_LIBRARIES, "install libopengl0");
}

}  // namespace knuckle
