#include "sim/gpu/device/egl.h"

#include <fmt/format.h>

#include <cstring>

#include "sim/gpu/device/driver_advice.h"
#include "sim/gpu/device/libraries.h"

namespace knuckle::egl {

namespace {

const char* errorWord(EGLint code)
{
    switch (code) {
        case EGL_NOT_INITIALIZED: return "the driver could not be initialized";
        case EGL_BAD_ACCESS: return "no permission to use the device";
        case EGL_BAD_ALLOC: return "the driver is out of memory or refuses another context";
        case EGL_BAD_MATCH: return "the driver has no OpenGL 4.3 core profile";
        case EGL_BAD_ATTRIBUTE: return "the driver does not know OpenGL 4.3 contexts";
        default: return "the driver refused";
    }
}

bool has(const char* extensions, const char* name)
{
    return extensions != nullptr && std::strstr(extensions, name) != nullptr;
}

/// Sets `function` to EGL's function `name`, if EGL has it.
template <typename Function>
void resolve(Function*& function, const char* name)
{
    if (auto* known = reinterpret_cast<Function*>(eglGetProcAddress(name))) function = known;
}

/// libepoxy resolves these two by asking GLX for its context once libGL is loaded, and aborts if that libGL has no GLX,
/// such as the one of apitrace's EGL tracer.
void resolveWithoutGlx()
{
    resolve(glGetString, "glGetString");
    resolve(glGetIntegerv, "glGetIntegerv");
}

/// Gives the display a context that is current on this thread. On failure destroys everything and returns the reason.
std::string makeCurrent(Context& result, EGLContext sharedWith)
{
    eglBindAPI(EGL_OPENGL_API);
    const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                                 4,
                                 EGL_CONTEXT_MINOR_VERSION,
                                 3,
                                 EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                 EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                 EGL_CONTEXT_OPENGL_DEBUG,
                                 EGL_TRUE,
                                 EGL_NONE};
    std::string problem;
    result.context = eglCreateContext(result.display, EGL_NO_CONFIG_KHR, sharedWith, attributes);
    if (result.context == EGL_NO_CONTEXT) {
        problem = fmt::format("no OpenGL 4.3 context: {}", errorWord(eglGetError()));
    } else if (!eglMakeCurrent(result.display, EGL_NO_SURFACE, EGL_NO_SURFACE, result.context)) {
        problem = fmt::format("the context cannot be used without a window: {}", errorWord(eglGetError()));
    }
    if (!problem.empty()) destroy(result);
    return problem;
}

}  // namespace

std::vector<Device> devices()
{
    requireLibraries();
    const char* extensions = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    if (!has(extensions, "EGL_EXT_device_enumeration") && !has(extensions, "EGL_EXT_device_base"))
        failOnDevice("EGL cannot list devices: no driver is found",
                     "install libegl1 and libgl1-mesa-dri (Mesa), or the vendor's driver");
    EGLint count = 0;
    eglQueryDevicesEXT(0, nullptr, &count);
    std::vector<EGLDeviceEXT> handles(static_cast<size_t>(count));
    if (count > 0) eglQueryDevicesEXT(count, handles.data(), &count);
    std::vector<Device> found;
    for (EGLDeviceEXT handle : handles) {
        const char* names = eglQueryDeviceStringEXT(handle, EGL_EXTENSIONS);
        Device device;
        device.handle = handle;
        device.software = has(names, "EGL_MESA_device_software");
        if (has(names, "EGL_EXT_device_drm")) {
            if (const char* file = eglQueryDeviceStringEXT(handle, EGL_DRM_DEVICE_FILE_EXT)) device.drmFile = file;
        }
        found.push_back(device);
    }
    return found;
}

Context create(const Device& device, std::string& problem)
{
    Context result;
    result.display = eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, device.handle, nullptr);
    if (result.display == EGL_NO_DISPLAY || !eglInitialize(result.display, nullptr, nullptr)) {
        problem = fmt::format("no display: {}", errorWord(eglGetError()));
        return {};
    }
    problem = makeCurrent(result, EGL_NO_CONTEXT);
    if (!problem.empty()) return {};
    resolveWithoutGlx();
    return result;
}

Context createSharing(const Context& other)
{
    Context result{other.display, EGL_NO_CONTEXT};
    const std::string problem = makeCurrent(result, other.context);
    if (!problem.empty()) failOnDevice(fmt::format("no second OpenGL context beside the first: {}", problem));
    return result;
}

void enter(const Context& context)
{
    if (!eglMakeCurrent(context.display, EGL_NO_SURFACE, EGL_NO_SURFACE, context.context))
        failOnDevice(fmt::format("an OpenGL context cannot change its thread: {}", errorWord(eglGetError())));
}

void leave(const Context& context)
{
    eglMakeCurrent(context.display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
}

void destroy(Context& context)
{
    if (context.display == EGL_NO_DISPLAY) return;
    if (eglGetCurrentContext() == context.context) leave(context);
    if (context.context != EGL_NO_CONTEXT) eglDestroyContext(context.display, context.context);
    // The display stays initialized: EGL shares it within the process, and another context may be alive.
    context = {};
}

}  // namespace knuckle::egl
