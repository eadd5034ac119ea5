#pragma once

#include <string>

#include "app/doctor/finding.h"
#include "app/run/open_gpu.h"

namespace knuckle {

/// What EGL and OpenGL need, and the devices that they have.
struct DriverFindings {
    Findings findings;
    bool usable = false;    ///< There is a device that makes films.
    bool software = false;  ///< It is the CPU.
};

/// @throws InputError for a device that is not there by its number, and for a word that names none.
DriverFindings findDriver(const CommonOptions& common);

/// An NVIDIA GPU without its part of EGL, as in containers. @param root of the file system, "" but in tests.
Findings findNvidia(const std::string& root);
/// GPUs that this user may not use. @param root of the file system, "" but in tests.
Findings findGpuFiles(const std::string& root);

}  // namespace knuckle
