#include "sim/gpu/buffer.h"

#include <fmt/format.h>

#include <algorithm>

#include "sim/world/errors.h"

namespace knuckle {

RawBuffer::RawBuffer(std::string label, size_t bytes, const void* data)
    : bytes_(std::max<size_t>(bytes, 16)), label_(std::move(label))
{
    while (glGetError() != GL_NO_ERROR) {}
    glGenBuffers(1, &id_);
    glBindBuffer(GL_SHADER_STORAGE_BUFFER, id_);
    glBufferData(GL_SHADER_STORAGE_BUFFER, static_cast<GLsizeiptr>(bytes_), bytes >= 16 ? data : nullptr,
                 GL_DYNAMIC_COPY);
    if (glGetError() == GL_OUT_OF_MEMORY) {
        glDeleteBuffers(1, &id_);
        throw DeviceError(fmt::format("the device has no memory for {} MiB of {}; use fewer particles",
                                      bytes_ >> 20, label_));
    }
    if (bytes < 16) clear();
    if (bytes > 0 && bytes < 16 && data != nullptr) write(data, bytes);
    glObjectLabel(GL_BUFFER, id_, -1, label_.c_str());
}

RawBuffer::~RawBuffer()
{
    if (texture_ != 0) glDeleteTextures(1, &texture_);
    if (id_ != 0) glDeleteBuffers(1, &id_);
}

RawBuffer::RawBuffer(RawBuffer&& other) noexcept
    : id_(std::exchange(other.id_, 0)), texture_(std::exchange(other.texture_, 0)), bytes_(other.bytes_),
      label_(std::move(other.label_))
{
}

RawBuffer& RawBuffer::operator=(RawBuffer&& other) noexcept
{
    std::swap(id_, other.id_);
    std::swap(texture_, other.texture_);
    std::swap(bytes_, other.bytes_);
    std::swap(label_, other.label_);
    return *this;
}

GLuint RawBuffer::texture(GLenum format)
{
    if (texture_ == 0) {
        glGenTextures(1, &texture_);
        glBindTexture(GL_TEXTURE_BUFFER, texture_);
        glTexBuffer(GL_TEXTURE_BUFFER, format, id_);
        glBindTexture(GL_TEXTURE_BUFFER, 0);
    }
    return texture_;
}

void RawBuffer::read(void* out, size_t byteCount, size_t byteOffset) const
{
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    glBindBuffer(GL_COPY_READ_BUFFER, id_);
    glGetBufferSubData(GL_COPY_READ_BUFFER, static_cast<GLintptr>(byteOffset), static_cast<GLsizeiptr>(byteCount),
                       out);
}

void RawBuffer::write(const void* data, size_t byteCount, size_t byteOffset)
{
    if (byteCount == 0) return;
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    glBindBuffer(GL_COPY_WRITE_BUFFER, id_);
    glBufferSubData(GL_COPY_WRITE_BUFFER, static_cast<GLintptr>(byteOffset), static_cast<GLsizeiptr>(byteCount), data);
}

void RawBuffer::clear()
{
    const uint32_t zero = 0;
    glBindBuffer(GL_COPY_WRITE_BUFFER, id_);
    glClearBufferData(GL_COPY_WRITE_BUFFER, GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, &zero);
}

}  // namespace knuckle
