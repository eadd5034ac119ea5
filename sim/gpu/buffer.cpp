#include "sim/gpu/buffer.h"

#include <fmt/format.h>

#include <algorithm>

#include "sim/base/errors.h"

namespace knuckle {

namespace {

/// NVIDIA's driver 580 loses a glBufferSubData that follows a copy or a clear: it executes it first. Zink of Mesa 25
/// executes both before an earlier kernel has read the buffer. They are rare, so they wait before and after.
void waitForAll()
{
    glFinish();
}

}  // namespace

RawBuffer::RawBuffer(std::string label, size_t bytes, const void* data)
    : handle_(BufferHandle::make()), bytes_(std::max<size_t>(bytes, 16)), label_(std::move(label))
{
    while (glGetError() != GL_NO_ERROR) {
    }
    glBindBuffer(GL_SHADER_STORAGE_BUFFER, id());
    glBufferData(GL_SHADER_STORAGE_BUFFER, static_cast<GLsizeiptr>(bytes_), bytes >= 16 ? data : nullptr,
                 GL_DYNAMIC_COPY);
    if (glGetError() == GL_OUT_OF_MEMORY)
        throw RunError(
            fmt::format("the device has no memory for {} MiB of {}; use fewer particles", bytes_ >> 20, label_));
    if (bytes < 16) clear();
    if (bytes > 0 && bytes < 16 && data != nullptr) write(data, bytes);
    glObjectLabel(GL_BUFFER, id(), -1, label_.c_str());
}

RawBuffer RawBuffer::standIn(std::string label, GLuint id, size_t bytes)
{
    RawBuffer buffer;
    buffer.standsFor_ = id;
    buffer.bytes_ = bytes;
    buffer.label_ = std::move(label);
    return buffer;
}

GLuint RawBuffer::texture(GLenum format) const
{
    if (texture_.id() == 0) {
        texture_ = TextureHandle::make();
        glBindTexture(GL_TEXTURE_BUFFER, texture_.id());
        glTexBuffer(GL_TEXTURE_BUFFER, format, id());
        glBindTexture(GL_TEXTURE_BUFFER, 0);
    }
    return texture_.id();
}

void RawBuffer::read(void* out, size_t byteCount, size_t byteOffset) const
{
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    glBindBuffer(GL_COPY_READ_BUFFER, id());
    glGetBufferSubData(GL_COPY_READ_BUFFER, static_cast<GLintptr>(byteOffset), static_cast<GLsizeiptr>(byteCount), out);
}

void RawBuffer::write(const void* data, size_t byteCount, size_t byteOffset)
{
    if (byteCount == 0) return;
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    glBindBuffer(GL_COPY_WRITE_BUFFER, id());
    glBufferSubData(GL_COPY_WRITE_BUFFER, static_cast<GLintptr>(byteOffset), static_cast<GLsizeiptr>(byteCount), data);
}

void RawBuffer::copy(const RawBuffer& from, size_t byteCount, size_t fromOffset, size_t toOffset)
{
    if (byteCount == 0) return;
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    waitForAll();
    glBindBuffer(GL_COPY_READ_BUFFER, from.id());
    glBindBuffer(GL_COPY_WRITE_BUFFER, id());
    glCopyBufferSubData(GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, static_cast<GLintptr>(fromOffset),
                        static_cast<GLintptr>(toOffset), static_cast<GLsizeiptr>(byteCount));
    waitForAll();
}

void RawBuffer::clear()
{
    const uint32_t zero = 0;
    waitForAll();
    glBindBuffer(GL_COPY_WRITE_BUFFER, id());
    glClearBufferData(GL_COPY_WRITE_BUFFER, GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, &zero);
    waitForAll();
}

}  // namespace knuckle
