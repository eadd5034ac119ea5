#pragma once

#include <string>
#include <vector>

#include "sim/gpu/bindings.h"
#include "sim/gpu/kernel.h"
#include "sim/gpu/texture.h"

namespace knuckle {

/// Files below shaders/render/, without their endings.
struct DrawShaders {
    std::string vertex, fragment;
    Defines defines = {};
};

/// Draw calls of an array of DrawElementsArguments.
struct IndexedDraws {
    uint32_t first = 0, count = 0;
    GLenum culled = GL_NONE;  ///< Like the pass's, for these draw calls.
};

/// A draw pass of the frame: a program that reads buffers and textures by their names and draws into one target. Its
/// time and label have the name of its fragment shader. There are no vertex attributes: shaders fetch their inputs.
class DrawPass {
public:
    DrawPass() = default;
    /// @param table must have "frame" and "view", which all shaders may declare.
    /// @param reads what else of it they may declare.
    /// @param target must outlive the pass. If it has a depth buffer, the depth test is on.
    /// @param culled GL_FRONT or GL_BACK, the faces that are not drawn.
    /// @throws DeviceError naming the pass and what it declares beyond that, or what the table lacks.
    DrawPass(const Gpu& gpu, const BufferTable& table, const DrawShaders& shaders,
             const std::vector<std::string>& reads, const Framebuffer& target, GLenum culled = GL_NONE);

    /// Blends its output with the target, 0 (invisible) ... 1 (the default, opaque).
    void setOpacity(float opacity) { opacity_ = opacity; }
    /// Adds its output to the target.
    void setAdditive() { additive_ = true; }
    const std::string& name() const { return program_.name(); }
    /// One triangle per instance over the whole target.
    void drawScreen(KernelTimer& timer, uint32_t instances = 1) const;
    /// @param primitive GL_POINTS, GL_TRIANGLES, ... @param first gl_VertexID of the first vertex.
    void draw(KernelTimer& timer, GLenum primitive, uint32_t vertices, uint32_t instances = 1,
              uint32_t first = 0) const;
    /// With the DrawArguments of `arguments` at element `index`.
    void drawIndirect(KernelTimer& timer, GLenum primitive, const RawBuffer& arguments, uint32_t index) const;
    /// Triangles of an index buffer of 32 bits, with some of the DrawElementsArguments of `arguments`.
    void drawIndexed(KernelTimer& timer, const RawBuffer& indices, const RawBuffer& arguments,
                     const IndexedDraws& which) const;

private:
    void begin(KernelTimer& timer) const;
    static void end(KernelTimer& timer);

    Program program_;
    Bindings bindings_;
    VertexArrayHandle noAttributes_;
    const Framebuffer* target_ = nullptr;
    GLenum culled_ = GL_NONE;
    float opacity_ = 1.0f;
    bool additive_ = false;
};

}  // namespace knuckle
