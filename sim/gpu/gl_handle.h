#pragma once

#include <epoxy/gl.h>

#include <type_traits>
#include <utility>

namespace knuckle {

/// Owns one GL object by its name, 0 for none. `generate` and `destroy` are GL's functions that make and delete it:
/// single objects, such as programs, or arrays, such as buffers.
template <auto& generate, auto& destroy>
class GlHandle {
public:
    GlHandle() = default;
    /// @param arguments of `generate`, for objects that are made one at a time.
    template <typename... T>
    static GlHandle make(T... arguments)
    {
        GlHandle handle;
        if constexpr (std::is_invocable_v<decltype(generate), T...>) handle.id_ = generate(arguments...);
        else generate(1, &handle.id_);
        return handle;
    }
    ~GlHandle()
    {
        if (id_ == 0) return;
        if constexpr (std::is_invocable_v<decltype(destroy), GLuint>) destroy(id_);
        else destroy(1, &id_);
    }
    GlHandle(GlHandle&& other) noexcept : id_(std::exchange(other.id_, 0)) {}
    GlHandle& operator=(GlHandle&& other) noexcept
    {
        std::swap(id_, other.id_);
        return *this;
    }

    GLuint id() const { return id_; }

private:
    GLuint id_ = 0;
};

using BufferHandle = GlHandle<glGenBuffers, glDeleteBuffers>;
using TextureHandle = GlHandle<glGenTextures, glDeleteTextures>;
using FramebufferHandle = GlHandle<glGenFramebuffers, glDeleteFramebuffers>;
using VertexArrayHandle = GlHandle<glGenVertexArrays, glDeleteVertexArrays>;
using QueryHandle = GlHandle<glGenQueries, glDeleteQueries>;
using ShaderHandle = GlHandle<glCreateShader, glDeleteShader>;
using ProgramHandle = GlHandle<glCreateProgram, glDeleteProgram>;

}  // namespace knuckle
