#pragma once

#include <string>

namespace knuckle {

/// The environment's variables that choose another driver or change what it offers, as "GALLIUM_DRIVER=softpipe and
/// MESA_GL_VERSION_OVERRIDE=3.0"; empty where none is set.
std::string driverVariables();

/// For what a device that can be used would not do. @throws RunError where memory is short, which is why it failed;
/// else DeviceError, which says to unset driverVariables(), where there are any, and what else to do where not.
[[noreturn]] void failOnDevice(const std::string& message, const std::string& remedy = {});

}  // namespace knuckle
