#pragma once

#include <epoxy/gl.h>

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "sim/gpu/device/driver_threads.h"
#include "sim/gpu/shader_source.h"

namespace knuckle {

/// The value of `--device`.
struct DeviceChoice {
    enum class Kind { Auto, Gpu, Software, Index } kind = Kind::Auto;
    uint32_t index = 0;

    /// Reads "auto", "gpu", "software" or a number. @throws InputError otherwise.
    static DeviceChoice parse(const std::string& text);
};

/// One EGL device, as `knuckle info` lists it.
struct DeviceInfo {
    uint32_t index = 0;
    bool software = false;
    std::string name;     ///< GL_RENDERER, or the EGL name if no context could be made.
    std::string version;  ///< GL_VERSION, empty if no context could be made.
    std::string problem;  ///< Empty if usable, else the reason.
};

/// GL limits that the solver and the renderer rely on.
struct DeviceLimits {
    int64_t storageBlockSize = 0;  ///< [bytes]
    int32_t computeStorageBlocks = 0;
    int32_t computeTextures = 0;
    int32_t textureBufferSize = 0;  ///< [texels]
    int32_t textureSize = 0;        ///< [pixels]
    int32_t workGroupCountX = 0;
    /// Of all loops that a thread runs through in a kernel. Mesa's software driver leaves them then, without an error.
    uint32_t loopRounds = UINT32_MAX;
};

/// Every EGL device, with a context tried on each. Never throws for a device that cannot be used.
std::vector<DeviceInfo> listDevices();

/// One headless OpenGL 4.3 core context, current on the thread that made it.
///
/// GL debug messages of high severity become a DeviceError at the next checkErrors().
class Gpu {
public:
    /// @param work of a frame, which determines a software driver's threads; without it the driver chooses.
    /// @throws DeviceError, with the reason, if no device fits or the context lacks a needed limit.
    explicit Gpu(const DeviceChoice& choice = {}, std::string shaderFolder = {}, std::optional<FrameWork> work = {});
    /// A second context that shares buffers, textures and fences with `other`, which outlives it, is current on this
    /// thread and stays so. The second is current nowhere: the thread that is to use it enters it, and leaves it before
    /// its end. Vertex arrays, framebuffers and queries are not shared.
    /// @throws DeviceError when the driver refuses.
    static std::unique_ptr<Gpu> sharingWith(const Gpu& other);
    ~Gpu();
    /// Makes it current on this thread, instead of another one. It must not be current on a second thread.
    /// @throws DeviceError when the driver refuses.
    void enter() const;
    /// Leaves this thread without a current context.
    void leave() const;
    Gpu(const Gpu&) = delete;
    Gpu& operator=(const Gpu&) = delete;

    const DeviceInfo& device() const { return device_; }
    const DeviceLimits& limits() const { return limits_; }
    const DriverThreads& threads() const { return threads_; }
    /// One line for the user if Auto had to fall back to software, else empty.
    const std::string& notice() const { return notice_; }
    const ShaderSource& shaders() const { return shaders_; }
    /// @throws DeviceError with the first high-severity message since the last call.
    void checkErrors();

private:
    struct Egl;
    explicit Gpu(const ShaderSource& shaders);
    void watchErrors();
    void makeContext(const DeviceChoice& choice);
    void readLimits();
    std::unique_ptr<Egl> egl_;
    DeviceInfo device_;
    DeviceLimits limits_;
    DriverThreads threads_;
    std::string notice_;
    std::string pendingError_;
    ShaderSource shaders_;
};

}  // namespace knuckle
