#pragma once

#include <epoxy/gl.h>

#include <algorithm>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "sim/gpu/gl_handle.h"

namespace knuckle {

/// An untyped, labelled GL buffer with, on demand, a buffer texture that views it.
class RawBuffer {
public:
    RawBuffer() = default;
    /// @param bytes at least 16 are allocated, so that an empty array still binds.
    /// @throws DeviceError when the driver has no memory for it.
    RawBuffer(std::string label, size_t bytes, const void* data = nullptr);
    /// Refers to a buffer with another owner, who keeps it alive. `id` may be 0.
    static RawBuffer standIn(std::string label, GLuint id, size_t bytes);

    GLuint id() const { return handle_.id() != 0 ? handle_.id() : standsFor_; }
    size_t bytes() const { return bytes_; }
    const std::string& label() const { return label_; }
    /// A buffer texture over the same storage; the format is fixed by the first call (GL_RGBA32F, GL_R32UI, ...).
    GLuint texture(GLenum format) const;
    void read(void* out, size_t byteCount, size_t byteOffset = 0) const;
    void write(const void* data, size_t byteCount, size_t byteOffset = 0);
    /// Copies bytes on the device, from a place in `from` to one in this.
    void copy(const RawBuffer& from, size_t byteCount, size_t fromOffset = 0, size_t toOffset = 0);
    void clear();

private:
    BufferHandle handle_;
    GLuint standsFor_ = 0;
    mutable TextureHandle texture_;
    size_t bytes_ = 0;
    std::string label_;
};

/// A RawBuffer of `size` elements of T (trivially copyable, laid out as in std430).
template <typename T>
class Buffer : public RawBuffer {
    static_assert(std::is_trivially_copyable_v<T>);

public:
    using Element = T;
    Buffer() = default;
    Buffer(std::string label, size_t size) : RawBuffer(std::move(label), size * sizeof(T)), size_(size) { clear(); }
    Buffer(std::string label, std::span<const T> data)
        : RawBuffer(std::move(label), data.size_bytes(), data.data()), size_(data.size())
    {
    }

    size_t size() const { return size_; }
    /// Stalls until the GPU is done: for exports, hashes and tests only.
    std::vector<T> download() const
    {
        std::vector<T> out(size_);
        if (size_ > 0) read(out.data(), size_ * sizeof(T));
        return out;
    }
    void upload(std::span<const T> data) { write(data.data(), data.size_bytes()); }
    /// Makes room for `size` elements. Contents stay: each of `parts` equal parts moves to the beginning of its larger
    /// one; new room holds zeros.
    void resize(std::string label, size_t size, size_t parts = 1)
    {
        if (id() != 0 && size == size_) return;
        Buffer resized(std::move(label), size);
        const size_t from = size_ / parts * sizeof(T), to = size / parts * sizeof(T);
        for (size_t part = 0; part < parts; ++part) resized.copy(*this, std::min(from, to), part * from, part * to);
        *this = std::move(resized);
    }

private:
    size_t size_ = 0;
};

}  // namespace knuckle
