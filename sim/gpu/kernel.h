#pragma once

#include <algorithm>
#include <cstdint>
#include <map>
#include <functional>
#include <string>
#include <vector>

#include "sim/gpu/buffer.h"
#include "sim/gpu/program.h"

namespace knuckle {

/// Buffers by the name that kernels know them by. A storage block `Positions` and a sampler `positions` both mean the
/// buffer "positions"; so does a sampler `lastPositions`, for kernels that write what they read. Those read only
/// elements that the same thread writes, or that nobody does.
class BufferTable {
public:
    /// @param texelBytes 4, 8 or 16: what one texel of the buffer's texture holds.
    void add(const std::string& name, RawBuffer& buffer, uint32_t texelBytes);
    /// Each under its label, a texel as large as an element, 16 bytes at most.
    template <typename... T>
    void add(Buffer<T>&... buffers)
    {
        (add(buffers.label(), buffers, static_cast<uint32_t>(std::min<size_t>(sizeof(T), 16))), ...);
    }
    struct Entry {
        RawBuffer* buffer = nullptr;
        uint32_t texelBytes = 4;
    };
    /// @throws DeviceError for an unknown name, saying which kernel asked.
    const Entry& find(const std::string& name, const std::string& kernel) const;

private:
    std::map<std::string, Entry> entries_;
};

/// Times of kernels by pairs of GL_TIMESTAMP (GL_TIME_ELAPSED always says 1 ns on llvmpipe).
class KernelTimer {
public:
    struct Total {
        double milliseconds = 0.0;
        uint64_t count = 0;
    };
    ~KernelTimer();
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
        GLuint start = 0, stop = 0;
    };
    void stamp(GLuint query) const;

    bool enabled_ = false;
    /// llvmpipe stamps when it gets to its queue of drawing, which computing does not wait for.
    bool waits_ = false;
    std::vector<std::pair<std::string, Total>> totals_;
    std::vector<Span> spans_;   ///< Reused from frame to frame.
    size_t used_ = 0;
};

/// A compute program with its buffers bound by name, dispatched with its label, its barrier and its time.
class Kernel {
public:
    Kernel() = default;
    /// @param path below shaders/. Every storage block, sampler and uniform block in it must be in the table.
    Kernel(const Gpu& gpu, const BufferTable& buffers, const std::string& path, const Defines& defines = {});

    const std::string& name() const { return program_.name(); }
    GLuint program() const { return program_.id(); }
    void dispatch(KernelTimer& timer, uint32_t groups) const;
    /// Group counts from `arguments` at element `index` of four words each.
    void dispatchIndirect(KernelTimer& timer, const RawBuffer& arguments, uint32_t index) const;

private:
    void bindStorage(const BufferTable& buffers);
    void bindTextures(const BufferTable& buffers);
    void bindUniformBlocks(const BufferTable& buffers);
    void begin(KernelTimer& timer) const;
    static void end(KernelTimer& timer);

    Program program_;
    std::vector<GLuint> storage_, textures_, uniforms_;   ///< Position is binding point.
};

/// Groups of GROUP_SIZE threads that cover `threads`.
uint32_t groupsFor(uint64_t threads);

/// Compiles a kernel of the simulation by its name.
using LoadKernel = std::function<Kernel(const char* name, Defines defines)>;

}  // namespace knuckle
