#include "render/draw_pass.h"

#include "shared/draw_types.h"

namespace knuckle {

namespace {

void enable(GLenum what, bool wanted)
{
    if (wanted) glEnable(what);
    else glDisable(what);
}

/// @param faces GL_FRONT or GL_BACK; GL_NONE: draws all.
void cull(GLenum faces)
{
    enable(GL_CULL_FACE, faces != GL_NONE);
    if (faces != GL_NONE) glCullFace(faces);
}

/// Every pass may ask for the frame and its view.
std::vector<std::string> withFrame(std::vector<std::string> reads)
{
    reads.insert(reads.end(), {"frame", "view"});
    return reads;
}

}  // namespace

DrawPass::DrawPass(const Gpu& gpu, const BufferTable& table, const DrawShaders& shaders,
                   const std::vector<std::string>& reads, const Framebuffer& target, GLenum culled)
    : program_(Program::graphics(gpu, "render/" + shaders.vertex + ".vert", "render/" + shaders.fragment + ".frag",
                                 shaders.defines)),
      bindings_(program_, table.only(withFrame(reads), "pass " + name()), "pass " + name()),
      noAttributes_(VertexArrayHandle::make()), target_(&target), culled_(culled)
{
}

void DrawPass::begin(KernelTimer& timer) const
{
    glPushDebugGroup(GL_DEBUG_SOURCE_APPLICATION, 0, -1, name().c_str());
    timer.begin(name());
    target_->bind();
    bindings_.bind();
    glBindVertexArray(noAttributes_.id());
    enable(GL_DEPTH_TEST, target_->hasDepth());
    cull(culled_);
    enable(GL_BLEND, additive_ || opacity_ < 1.0f);
    if (additive_) glBlendFunc(GL_ONE, GL_ONE);
    else glBlendFunc(GL_CONSTANT_ALPHA, GL_ONE_MINUS_CONSTANT_ALPHA);
    glBlendColor(0.0f, 0.0f, 0.0f, opacity_);
}

void DrawPass::end(KernelTimer& timer)
{
    timer.end();
    glPopDebugGroup();
}

void DrawPass::drawScreen(KernelTimer& timer, uint32_t instances) const
{
    draw(timer, GL_TRIANGLES, 3, instances);
}

void DrawPass::draw(KernelTimer& timer, GLenum primitive, uint32_t vertices, uint32_t instances, uint32_t first) const
{
    if (vertices == 0 || instances == 0) return;
    begin(timer);
    glDrawArraysInstanced(primitive, static_cast<GLint>(first), static_cast<GLsizei>(vertices),
                          static_cast<GLsizei>(instances));
    end(timer);
}

void DrawPass::drawIndirect(KernelTimer& timer, GLenum primitive, const RawBuffer& arguments, uint32_t index) const
{
    begin(timer);
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, arguments.id());
    glDrawArraysIndirect(primitive, reinterpret_cast<const void*>(index * sizeof(gpu::DrawArguments)));
    end(timer);
}

void DrawPass::drawIndexed(KernelTimer& timer, const RawBuffer& indices, const RawBuffer& arguments,
                           const IndexedDraws& which) const
{
    if (which.count == 0) return;
    begin(timer);
    if (which.culled != GL_NONE) cull(which.culled);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices.id());
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, arguments.id());
    const size_t offset = which.first * sizeof(gpu::DrawElementsArguments);
    glMultiDrawElementsIndirect(GL_TRIANGLES, GL_UNSIGNED_INT, reinterpret_cast<const void*>(offset),
                                static_cast<GLsizei>(which.count), 0);
    end(timer);
}

}  // namespace knuckle
