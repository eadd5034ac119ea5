#pragma once

#include <string>
#include <vector>

namespace knuckle {

/// What has OpenGL's functions: either will do.
inline const std::vector<std::string> OPENGL_LIBRARIES{"libOpenGL.so.0", "libGL.so.1"};

/// Loads the first of the libraries that can be, for good. @returns why none can; empty: one is.
std::string loadProblem(const std::vector<std::string>& libraries);

/// Loads EGL and OpenGL before libepoxy does, which ends the program where it cannot. @throws DeviceError.
void requireLibraries();

}  // namespace knuckle
