#pragma once

// epoxy must come before any EGL header: it replaces them.
#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <cstdint>
#include <string>
#include <vector>

namespace knuckle::egl {

/// One EGL device of EGL_EXT_device_enumeration.
struct Device {
    EGLDeviceEXT handle = nullptr;
    bool software = false;
    std::string drmFile;  ///< Empty for Mesa's software device.
};

/// @throws DeviceError with the reason if EGL itself is missing or cannot enumerate devices.
std::vector<Device> devices();

/// A display and a context without a surface.
struct Context {
    EGLDisplay display = EGL_NO_DISPLAY;
    EGLContext context = EGL_NO_CONTEXT;
};

/// A GL 4.3 core context on `device`, current on this thread. On failure the context is empty and `problem` says why.
Context create(const Device& device, std::string& problem);
/// A context that shares buffers, textures and fences with `other`, current on this thread instead of it.
/// @throws DeviceError when the driver refuses; `other` then stays current.
Context createSharing(const Context& other);
/// Makes it current on this thread instead of another context. @throws DeviceError when the driver refuses.
void enter(const Context& context);
/// Makes no context current on this thread.
void leave(const Context& context);
void destroy(Context& context);

}  // namespace knuckle::egl
