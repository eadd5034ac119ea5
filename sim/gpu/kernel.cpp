#include "sim/gpu/kernel.h"

#include <fmt/format.h>

#include "shared/constants.h"
#include "sim/base/errors.h"

namespace knuckle {

void KernelTimer::enable(const Gpu& gpu)
{
    enabled_ = true;
    waits_ = gpu.device().software;
}

void KernelTimer::stamp(GLuint query) const
{
    glQueryCounter(query, GL_TIMESTAMP);
    if (waits_) glFinish();
}

void KernelTimer::begin(const std::string& name)
{
    if (!enabled_) return;
    size_t total = 0;
    while (total < totals_.size() && totals_[total].first != name) ++total;
    if (total == totals_.size()) totals_.push_back({name, {}});
    if (used_ == spans_.size()) spans_.emplace_back();
    spans_[used_].total = total;
    stamp(spans_[used_].start.id());
}

void KernelTimer::end()
{
    if (enabled_) stamp(spans_[used_++].stop.id());
}

void KernelTimer::collect()
{
    for (size_t i = 0; i < used_; ++i) {
        GLuint64 start = 0, stop = 0;
        glGetQueryObjectui64v(spans_[i].start.id(), GL_QUERY_RESULT, &start);
        glGetQueryObjectui64v(spans_[i].stop.id(), GL_QUERY_RESULT, &stop);
        Total& total = totals_[spans_[i].total].second;
        total.milliseconds += 1e-6 * static_cast<double>(stop - start);
        ++total.count;
    }
    used_ = 0;
}

Kernel::Kernel(const Gpu& gpu, const BufferTable& buffers, const std::string& path, const Defines& defines,
               const std::string& variant, const Renames& renames)
    : program_(Program::compute(gpu, path, defines)), name_(program_.name() + variant),
      bindings_(program_, buffers, "kernel " + name_, renames)
{
    const auto check = [&](size_t used, size_t promised, const char* what) {
        if (used > promised)
            throw DeviceError(
                fmt::format("kernel {} uses {} {}; OpenGL 4.3 promises {}", name(), used, what, promised));
    };
    check(bindings_.storageCount(), 8, "storage buffers");
    check(bindings_.textureCount(), 16, "textures");
    check(bindings_.imageCount(), 8, "images");
}

void Kernel::begin(KernelTimer& timer) const
{
    glPushDebugGroup(GL_DEBUG_SOURCE_APPLICATION, 0, -1, name().c_str());
    bindings_.bind();
    timer.begin(name());
}

void Kernel::end(KernelTimer& timer)
{
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT | GL_UNIFORM_BARRIER_BIT |
                    GL_COMMAND_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
    timer.end();
    glPopDebugGroup();
}

void Kernel::dispatch(KernelTimer& timer, uint32_t groups) const
{
    begin(timer);
    glDispatchCompute(groups, 1, 1);
    end(timer);
}

void Kernel::dispatchIndirect(KernelTimer& timer, const RawBuffer& arguments, uint32_t index) const
{
    begin(timer);
    glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, arguments.id());
    glDispatchComputeIndirect(GLintptr{16} * index);
    end(timer);
}

void Kernel::compile() const
{
    // Not its own buffers: when two contexts use a buffer texture for the first time at once, Mesa 22.3 loses count of
    // who uses it, and later writes to what it has freed.
    Placeholders others;
    bindings_.bind(others);
    const Buffer<gpu::uvec4> noGroups("noGroups", 1);
    glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, noGroups.id());
    glDispatchComputeIndirect(0);
}

uint32_t groupsFor(uint64_t threads)
{
    return static_cast<uint32_t>((threads + GROUP_SIZE - 1) / GROUP_SIZE);
}

}  // namespace knuckle
