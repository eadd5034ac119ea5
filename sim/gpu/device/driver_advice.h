#pragma once

#include <string>

namespace knuckle {

/// Environment variables that choose another driver or change its features, such as "GALLIUM_DRIVER=softpipe and
/// MESA_GL_VERSION_OVERRIDE=3.0"; empty if none is set.
std::string driverVariables();

/// For an operation that a usable device fails at. @throws RunError if memory is short, which is then the cause; else
/// DeviceError, which advises to unset driverVariables() if there are any, and otherwise gives the remedy.
[[noreturn]] void failOnDevice(const std::string& message, const std::string& remedy = {});

}  // namespace knuckle
