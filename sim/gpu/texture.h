#pragma once

#include <cstdint>
#include <initializer_list>
#include <string>
#include <vector>

#include "sim/gpu/gl_handle.h"

namespace knuckle {

/// A 2D texture without mipmaps, clamped at its edges.
class Texture {
public:
    Texture() = default;
    /// @param filter GL_NEAREST or GL_LINEAR.
    Texture(std::string label, GLenum format, uint32_t width, uint32_t height, GLint filter = GL_NEAREST);

    GLuint id() const { return handle_.id(); }
    const std::string& label() const { return label_; }
    uint32_t width() const { return width_; }
    uint32_t height() const { return height_; }
    /// Whether its texels are integers.
    bool isInteger() const;
    /// Copies from a texture of the same size and format.
    void copy(const Texture& source);

private:
    TextureHandle handle_;
    std::string label_;
    GLenum format_ = GL_NONE;
    uint32_t width_ = 0, height_ = 0;
};

/// Textures that are drawn into together.
class Framebuffer {
public:
    Framebuffer() = default;
    /// @param depth may be null. The textures must outlive it.
    /// @throws DeviceError when the device cannot draw into them.
    Framebuffer(std::string label, std::initializer_list<const Texture*> colors, const Texture* depth);

    GLuint id() const { return handle_.id(); }
    bool hasDepth() const { return hasDepth_; }
    /// Makes it the target of what follows, with a viewport over all of it.
    void bind() const;
    /// Clears colours to 0, and depth to 1.
    void clear() const;

private:
    FramebufferHandle handle_;
    uint32_t width_ = 0, height_ = 0;
    std::vector<bool> integers_;  ///< Of each colour, whether its texels are.
    bool hasDepth_ = false;
};

}  // namespace knuckle
