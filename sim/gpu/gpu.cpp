#include "sim/gpu/gpu.h"

#include <fmt/format.h>

#include <atomic>
#include <charconv>
#include <cstdlib>

#include "sim/base/errors.h"
#include "sim/base/memory.h"
#include "sim/gpu/device/driver_advice.h"
#include "sim/gpu/device/egl.h"

namespace knuckle {

namespace {

std::string glString(GLenum name)
{
    const auto* text = reinterpret_cast<const char*>(glGetString(name));
    return text != nullptr ? text : "";
}

bool isSoftwareRenderer(const std::string& renderer)
{
    return renderer.find("llvmpipe") != std::string::npos || renderer.find("softpipe") != std::string::npos ||
           renderer.find("swrast") != std::string::npos;
}

/// The order in which Auto and Gpu try devices: hardware first, software last.
std::vector<uint32_t> preferredOrder(const std::vector<egl::Device>& devices, const DeviceChoice& choice)
{
    using Kind = DeviceChoice::Kind;
    std::vector<uint32_t> order;
    for (bool software : {false, true}) {
        if ((software && choice.kind == Kind::Gpu) || (!software && choice.kind == Kind::Software)) continue;
        for (uint32_t i = 0; i < devices.size(); ++i)
            if (devices[i].software == software) order.push_back(i);
    }
    if (choice.kind == Kind::Index) order = {choice.index};
    return order;
}

void GLAPIENTRY onDebugMessage(GLenum, GLenum type, GLuint, GLenum severity, GLsizei, const GLchar* text,
                               const void* user)
{
    auto* pending = static_cast<std::string*>(const_cast<void*>(user));
    if ((severity == GL_DEBUG_SEVERITY_HIGH || type == GL_DEBUG_TYPE_ERROR) && pending->empty()) *pending = text;
}

/// Sets 256-bit vectors: with 512 bits Mesa 22.3's llvmpipe runs compute kernels a little faster, but crashes when it
/// compiles any fragment shader.
void tuneSoftwareDriver()
{
    // Our own error line covers drivers that cannot be loaded.
    setenv("EGL_LOG_LEVEL", "fatal", 0);
    setenv("LP_NATIVE_VECTOR_WIDTH", "256", 0);
}

// Address space that Mesa's software driver needs [bytes]: with less it crashes instead of failing.
constexpr uint64_t DRIVER_SPACE = uint64_t{230} << 20, SHADER_SPACE = uint64_t{80} << 20;

/// To be called before the driver is loaded. @throws RunError.
void requireSpace(uint64_t byteCount)
{
    static std::atomic<bool> isLoaded = false;
    const auto limit = addressSpaceLimit();
    if (!isLoaded.exchange(true) && limit && *limit < addressSpaceInUse() + byteCount) throw RunError(memoryMessage());
}

}  // namespace

struct Gpu::Egl {
    egl::Context context;
};

DeviceChoice DeviceChoice::parse(const std::string& text)
{
    if (text == "auto") return {Kind::Auto, 0};
    if (text == "gpu") return {Kind::Gpu, 0};
    if (text == "software") return {Kind::Software, 0};
    uint32_t index = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), index);
    if (error != std::errc{} || end != text.data() + text.size() || text.empty())
        throw InputError(fmt::format("--device: \"{}\" is not a device; use auto, gpu, software or an index from "
                                     "`knuckle info`",
                                     text));
    return {Kind::Index, index};
}

std::vector<DeviceInfo> listDevices()
{
    requireSpace(DRIVER_SPACE);
    tuneSoftwareDriver();
    std::vector<DeviceInfo> infos;
    const auto devices = egl::devices();
    for (uint32_t i = 0; i < devices.size(); ++i) {
        DeviceInfo info;
        info.index = i;
        info.software = devices[i].software;
        info.name = devices[i].software ? "software device" : devices[i].drmFile;
        egl::Context context = egl::create(devices[i], info.problem);
        if (info.problem.empty()) {
            info.name = glString(GL_RENDERER);
            info.version = glString(GL_VERSION);
            info.software = info.software || isSoftwareRenderer(info.name);
        }
        egl::destroy(context);
        infos.push_back(info);
    }
    return infos;
}

Gpu::Gpu(const DeviceChoice& choice, std::string shaderFolder, std::optional<FrameWork> work)
    : egl_(std::make_unique<Egl>()), shaders_(std::move(shaderFolder))
{
    tuneSoftwareDriver();
    requireSpace(DRIVER_SPACE + (work ? SHADER_SPACE : 0));
    if (work) threads_ = applyDriverThreads(*work);
    makeContext(choice);
    if (!device_.software) threads_ = {{}, false, "the device is no software renderer"};
    watchErrors();
    readLimits();
}

Gpu::Gpu(const ShaderSource& shaders) : egl_(std::make_unique<Egl>()), shaders_(shaders) {}

std::unique_ptr<Gpu> Gpu::sharingWith(const Gpu& other)
{
    std::unique_ptr<Gpu> gpu(new Gpu(other.shaders_));
    gpu->device_ = other.device_;
    gpu->limits_ = other.limits_;
    gpu->threads_ = other.threads_;
    gpu->egl_->context = egl::createSharing(other.egl_->context);
    gpu->watchErrors();
    other.enter();
    return gpu;
}

void Gpu::enter() const
{
    egl::enter(egl_->context);
}

void Gpu::leave() const
{
    egl::leave(egl_->context);
}

Gpu::~Gpu()
{
    egl::destroy(egl_->context);
}

void Gpu::watchErrors()
{
    glEnable(GL_DEBUG_OUTPUT);
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    // Debug groups would cause a notification per pass.
    glDebugMessageControl(GL_DONT_CARE, GL_DONT_CARE, GL_DEBUG_SEVERITY_NOTIFICATION, 0, nullptr, GL_FALSE);
    glDebugMessageCallback(onDebugMessage, &pendingError_);
}

void Gpu::makeContext(const DeviceChoice& choice)
{
    const auto devices = egl::devices();
    if (choice.kind == DeviceChoice::Kind::Index && choice.index >= devices.size())
        throw InputError(fmt::format("--device {}: there are only {} devices; `knuckle info` lists them", choice.index,
                                     devices.size()));
    std::string problems;
    for (uint32_t index : preferredOrder(devices, choice)) {
        std::string problem;
        egl::Context context = egl::create(devices[index], problem);
        if (!problem.empty()) {
            problems += fmt::format("; device {}: {}", index, problem);
            continue;
        }
        device_ = {index,
                   devices[index].software || isSoftwareRenderer(glString(GL_RENDERER)),
                   glString(GL_RENDERER),
                   glString(GL_VERSION),
                   {}};
        // A hardware device without a driver of its own may give Mesa's software renderer.
        if (choice.kind == DeviceChoice::Kind::Gpu && device_.software) {
            problems += fmt::format("; device {}: only a software renderer ({})", index, device_.name);
            egl::destroy(context);
            continue;
        }
        egl_->context = context;
        if (choice.kind == DeviceChoice::Kind::Auto && device_.software)
            notice_ = fmt::format("no hardware device can be used: running on {}", device_.name);
        return;
    }
    const char* remedy = choice.kind == DeviceChoice::Kind::Gpu ? "try --device software"
                                                                : "install libgl1-mesa-dri for Mesa's software device";
    failOnDevice("no OpenGL 4.3 context can be made" + (problems.empty() ? ": EGL lists no such device" : problems),
                 remedy);
}

void Gpu::readLimits()
{
    glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &limits_.storageBlockSize);
    glGetIntegerv(GL_MAX_COMPUTE_SHADER_STORAGE_BLOCKS, &limits_.computeStorageBlocks);
    glGetIntegerv(GL_MAX_COMPUTE_TEXTURE_IMAGE_UNITS, &limits_.computeTextures);
    glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &limits_.textureBufferSize);
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &limits_.textureSize);
    glGetIntegeri_v(GL_MAX_COMPUTE_WORK_GROUP_COUNT, 0, &limits_.workGroupCountX);
    if (device_.software) limits_.loopRounds = 65535;  // LP_MAX_TGSI_LOOP_ITERATIONS
    if (limits_.computeStorageBlocks < 8)
        failOnDevice(fmt::format("{}: {} storage buffers a compute kernel, and 8 are needed (OpenGL 4.3 promises them)",
                                 device_.name, limits_.computeStorageBlocks),
                     "update the driver or choose another --device");
}

void Gpu::checkErrors()
{
    GLenum error = glGetError();
    if (pendingError_.empty() && error != GL_NO_ERROR)
        pendingError_ = error == GL_OUT_OF_MEMORY ? "GL_OUT_OF_MEMORY" : fmt::format("error 0x{:04x}", error);
    if (pendingError_.empty()) return;
    std::string text;
    text.swap(pendingError_);
    if (text.find("OUT_OF_MEMORY") != std::string::npos) throw RunError(memoryMessage());
    failOnDevice(fmt::format("OpenGL on {}: {}", device_.name, text));
}

}  // namespace knuckle
