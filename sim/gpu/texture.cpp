#include "sim/gpu/texture.h"

#include <fmt/format.h>

#include <utility>

#include "sim/base/errors.h"
#include "sim/base/memory.h"
#include "sim/gpu/device/driver_advice.h"

namespace knuckle {

Texture::Texture(std::string label, GLenum format, uint32_t width, uint32_t height, GLint filter)
    : handle_(TextureHandle::make()), label_(std::move(label)), format_(format), width_(width), height_(height)
{
    glBindTexture(GL_TEXTURE_2D, id());
    glTexStorage2D(GL_TEXTURE_2D, 1, format, static_cast<GLsizei>(width), static_cast<GLsizei>(height));
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glObjectLabel(GL_TEXTURE, id(), -1, label_.c_str());
}

bool Texture::isInteger() const
{
    return format_ == GL_R32UI || format_ == GL_RG32UI;
}

void Texture::copy(const Texture& source)
{
    glCopyImageSubData(source.id(), GL_TEXTURE_2D, 0, 0, 0, 0, id(), GL_TEXTURE_2D, 0, 0, 0, 0,
                       static_cast<GLsizei>(width_), static_cast<GLsizei>(height_), 1);
}

Framebuffer::Framebuffer(std::string label, std::initializer_list<const Texture*> colors, const Texture* depth)
    : handle_(FramebufferHandle::make()), hasDepth_(depth != nullptr)
{
    glBindFramebuffer(GL_FRAMEBUFFER, id());
    std::vector<GLenum> buffers;
    for (const Texture* color : colors) {
        buffers.push_back(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(buffers.size()));
        glFramebufferTexture(GL_FRAMEBUFFER, buffers.back(), color->id(), 0);
        integers_.push_back(color->isInteger());
    }
    if (depth != nullptr) glFramebufferTexture(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, depth->id(), 0);
    const Texture& sized = depth != nullptr ? *depth : **colors.begin();
    width_ = sized.width();
    height_ = sized.height();
    glDrawBuffers(static_cast<GLsizei>(buffers.size()), buffers.data());
    glObjectLabel(GL_FRAMEBUFFER, id(), -1, label.c_str());
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE) return;
    if (glGetError() == GL_OUT_OF_MEMORY) throw RunError(memoryMessage());
    failOnDevice(fmt::format("the device cannot draw into {} at {}x{}", label, width_, height_),
                 "try a smaller --size");
}

void Framebuffer::bind() const
{
    glBindFramebuffer(GL_FRAMEBUFFER, id());
    glViewport(0, 0, static_cast<GLsizei>(width_), static_cast<GLsizei>(height_));
}

void Framebuffer::clear() const
{
    bind();
    const GLuint nothing[4] = {0, 0, 0, 0};
    const GLfloat black[4] = {0, 0, 0, 0};
    for (GLint color = 0; color < static_cast<GLint>(integers_.size()); ++color) {
        if (integers_[static_cast<size_t>(color)]) glClearBufferuiv(GL_COLOR, color, nothing);
        else glClearBufferfv(GL_COLOR, color, black);
    }
    if (hasDepth_) glClear(GL_DEPTH_BUFFER_BIT);
}

}  // namespace knuckle
