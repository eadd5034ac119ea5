#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "sim/gpu/bindings.h"
#include "sim/gpu/program.h"

namespace knuckle {

/// Times of kernels by pairs of GL_TIMESTAMP (GL_TIME_ELAPSED is always 1 ns on llvmpipe).
class KernelTimer {
public:
    struct Total {
        double milliseconds = 0.0;
        uint64_t count = 0;
    };
    void enable(const Gpu& gpu);
    void begin(const std::string& name);
    void end();
    /// Adds up the finished pairs. Waits for the last of them.
    void collect();
    /// In the order of first use.
    const std::vector<std::pair<std::string, Total>>& totals() const { return totals_; }

private:
    struct Span {
        size_t total = 0;
        QueryHandle start = QueryHandle::make(), stop = QueryHandle::make();
    };
    void stamp(GLuint query) const;

    bool enabled_ = false;
    /// llvmpipe takes a timestamp when its drawing queue gets to it, and compute kernels do not wait for that queue: so
    /// the timer waits itself.
    bool waits_ = false;
    std::vector<std::pair<std::string, Total>> totals_;
    std::vector<Span> spans_;  ///< Reused from frame to frame.
    size_t used_ = 0;
};

/// A compute program with its buffers bound by name, dispatched with its label, its barrier and its time. It refers to
/// the buffers: after an assignment to one, because a list grew, it binds the new one by itself.
class Kernel {
public:
    Kernel() = default;
    /// @param path below shaders/. Every storage block, sampler and uniform block in it must be in the table, with the
    /// host's type of element.
    /// @param variant tells the kernel apart from others of the same file, in times and labels; may be empty.
    /// @param renames buffers that it gets for those that it declares.
    /// @throws DeviceError with the kernel's name and its declaration that does not match.
    Kernel(const Gpu& gpu, const BufferTable& buffers, const std::string& path, const Defines& defines = {},
           const std::string& variant = {}, const Renames& renames = {});

    const std::string& name() const { return name_; }
    GLuint program() const { return program_.id(); }
    /// @throws DeviceError for a buffer that is too large for the device.
    void checkSizes(const Gpu& gpu) const { bindings_.checkSizes(gpu, "kernel " + name_); }
    void dispatch(KernelTimer& timer, uint32_t groups) const;
    /// Group counts from `arguments` at element `index` of four words each.
    void dispatchIndirect(KernelTimer& timer, const RawBuffer& arguments, uint32_t index) const;
    /// Has the driver compile it for what it is bound to, which a software driver else does at the first dispatch, in
    /// each context by itself. What one has compiled another finds in the driver's cache on disk.
    void compile() const;

private:
    void begin(KernelTimer& timer) const;
    static void end(KernelTimer& timer);

    Program program_;
    std::string name_;
    Bindings bindings_;
};

/// Groups of GROUP_SIZE threads that cover `threads`.
uint32_t groupsFor(uint64_t threads);

/// Compiles a kernel of the simulation: its path below shaders/sim, and the defines of this variant of it.
using LoadKernel = std::function<Kernel(const char* path, const Defines& variant)>;

}  // namespace knuckle
