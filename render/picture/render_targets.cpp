#include "render/picture/render_targets.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "sim/world/errors.h"

namespace knuckle {

Texture::Texture(std::string label, GLenum format, uint32_t width, uint32_t height, GLint filter)
    : width_(width), height_(height)
{
    glGenTextures(1, &id_);
    glBindTexture(GL_TEXTURE_2D, id_);
    glTexStorage2D(GL_TEXTURE_2D, 1, format, static_cast<GLsizei>(width), static_cast<GLsizei>(height));
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glObjectLabel(GL_TEXTURE, id_, -1, label.c_str());
}

Texture::~Texture()
{
    if (id_ != 0) glDeleteTextures(1, &id_);
}

Texture::Texture(Texture&& other) noexcept
    : id_(std::exchange(other.id_, 0)), width_(other.width_), height_(other.height_)
{
}

Texture& Texture::operator=(Texture&& other) noexcept
{
    std::swap(id_, other.id_);
    std::swap(width_, other.width_);
    std::swap(height_, other.height_);
    return *this;
}

void Texture::bind(GLuint unit) const
{
    glActiveTexture(GL_TEXTURE0 + unit);
    glBindTexture(GL_TEXTURE_2D, id_);
}

Framebuffer::Framebuffer(std::string label, std::initializer_list<const Texture*> colors, const Texture* depth)
{
    glGenFramebuffers(1, &id_);
    glBindFramebuffer(GL_FRAMEBUFFER, id_);
    std::vector<GLenum> buffers;
    for (const Texture* color : colors) {
        buffers.push_back(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(buffers.size()));
        glFramebufferTexture(GL_FRAMEBUFFER, buffers.back(), color->id(), 0);
    }
    if (depth != nullptr) glFramebufferTexture(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, depth->id(), 0);
    const Texture& sized = depth != nullptr ? *depth : **colors.begin();
    width_ = sized.width();
    height_ = sized.height();
    glDrawBuffers(static_cast<GLsizei>(buffers.size()), buffers.data());
    glObjectLabel(GL_FRAMEBUFFER, id_, -1, label.c_str());
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE) return;
    glDeleteFramebuffers(1, &id_);
    throw DeviceError(fmt::format("the device cannot draw into {} at {}x{}; try a smaller --size", label, width_,
                                  height_));
}

Framebuffer::~Framebuffer()
{
    if (id_ != 0) glDeleteFramebuffers(1, &id_);
}

Framebuffer::Framebuffer(Framebuffer&& other) noexcept
    : id_(std::exchange(other.id_, 0)), width_(other.width_), height_(other.height_)
{
}

Framebuffer& Framebuffer::operator=(Framebuffer&& other) noexcept
{
    std::swap(id_, other.id_);
    std::swap(width_, other.width_);
    std::swap(height_, other.height_);
    return *this;
}

void Framebuffer::bind() const
{
    glBindFramebuffer(GL_FRAMEBUFFER, id_);
    glViewport(0, 0, static_cast<GLsizei>(width_), static_cast<GLsizei>(height_));
}

RenderTargets::RenderTargets(uint32_t width, uint32_t height, uint32_t factor)
{
    const uint32_t w = width * factor, h = height * factor, halfW = (w + 1) / 2, halfH = (h + 1) / 2;
    surface = Texture("surface", GL_RG32UI, w, h);
    depth = Texture("depth", GL_DEPTH_COMPONENT32F, w, h);
    shadow = Texture("shadow", GL_DEPTH_COMPONENT32F, SHADOW_SIZE, SHADOW_SIZE);
    shade = Texture("shade", GL_R32UI, halfW, halfH);
    picture = Texture("picture", GL_RGBA8, w, h, GL_LINEAR);
    smoothed = Texture("smoothed", GL_RGBA8, w, h);
    geometry = Framebuffer("geometry", {&surface}, &depth);
    shadowMap = Framebuffer("shadow map", {}, &shadow);
    occlusion = Framebuffer("occlusion", {&shade}, nullptr);
    lighting = Framebuffer("lighting", {&picture}, nullptr);
    edges = Framebuffer("edge filter", {&smoothed}, nullptr);
    if (factor == 1) return;
    resolved = Texture("resolved", GL_RGBA8, width, height);
    resolve = Framebuffer("resolve", {&resolved}, nullptr);
}

}  // namespace knuckle
