#pragma once

#include <epoxy/gl.h>

#include <cstdint>
#include <initializer_list>
#include <string>

namespace knuckle {

/// A 2D texture without mipmaps that clamps at its edges.
class Texture {
public:
    Texture() = default;
    /// @param filter GL_NEAREST or GL_LINEAR.
    Texture(std::string label, GLenum format, uint32_t width, uint32_t height, GLint filter = GL_NEAREST);
    ~Texture();
    Texture(Texture&& other) noexcept;
    Texture& operator=(Texture&& other) noexcept;

    GLuint id() const { return id_; }
    uint32_t width() const { return width_; }
    uint32_t height() const { return height_; }
    void bind(GLuint unit) const;

private:
    GLuint id_ = 0;
    uint32_t width_ = 0, height_ = 0;
};

/// Textures drawn into together.
class Framebuffer {
public:
    Framebuffer() = default;
    /// @param depth may be null. The textures must outlive it.
    Framebuffer(std::string label, std::initializer_list<const Texture*> colors, const Texture* depth);
    ~Framebuffer();
    Framebuffer(Framebuffer&& other) noexcept;
    Framebuffer& operator=(Framebuffer&& other) noexcept;

    GLuint id() const { return id_; }
    /// Makes it the target of what follows, with the viewport over all of it.
    void bind() const;

private:
    GLuint id_ = 0;
    uint32_t width_ = 0, height_ = 0;
};

/// Everything that a frame is drawn into.
struct RenderTargets {
    /// @param factor samples an axis and pixel.
    RenderTargets(uint32_t width, uint32_t height, uint32_t factor);

    Texture surface, depth;             ///< Normals and colours, and depth, of what is seen.
    Texture shadow;                     ///< Depth as the key light sees it.
    Texture shade;                      ///< Half resolution: see shade.glsl.
    Texture picture, smoothed;          ///< As displayed, before and after the edges are smoothed.
    Texture resolved;                   ///< The frame.
    Framebuffer geometry, shadowMap, occlusion, lighting, edges, resolve;
};

/// Texels a side of the shadow map.
inline constexpr uint32_t SHADOW_SIZE = 1024;

}  // namespace knuckle
