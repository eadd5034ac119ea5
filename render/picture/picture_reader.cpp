#include "render/picture/picture_reader.h"

#include <algorithm>

#include "sim/base/errors.h"

namespace knuckle {

namespace {

constexpr size_t BYTES_PER_PIXEL = 4;

/// Passes multiply colours by what they cover.
void divideByAlpha(Image& image)
{
    for (size_t i = 0; i < image.alpha.size(); ++i) {
        const uint32_t alpha = image.alpha[i];
        if (alpha == 0 || alpha == 255) continue;
        for (size_t k = 3 * i; k < 3 * i + 3; ++k)
            image.rgb[k] = static_cast<uint8_t>(std::min((255u * image.rgb[k] + alpha / 2) / alpha, 255u));
    }
}

}  // namespace

PictureReader::PictureReader(uint32_t width, uint32_t height, bool hasAlpha)
    : width_(width), height_(height), hasAlpha_(hasAlpha), buffer_(BufferHandle::make())
{
    glBindBuffer(GL_PIXEL_PACK_BUFFER, buffer_.id());
    glBufferData(GL_PIXEL_PACK_BUFFER, static_cast<GLsizeiptr>(BYTES_PER_PIXEL * width * height), nullptr,
                 GL_STREAM_READ);
    glObjectLabel(GL_BUFFER, buffer_.id(), -1, "picture read-back");
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
}

void PictureReader::start(GLuint framebuffer)
{
    started_ = true;
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer);
    glReadBuffer(GL_COLOR_ATTACHMENT0);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, buffer_.id());
    glReadPixels(0, 0, static_cast<GLsizei>(width_), static_cast<GLsizei>(height_), GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
}

Image PictureReader::last()
{
    if (!started_) throw RunError("there is no picture to read: nothing has been drawn yet");
    glBindBuffer(GL_PIXEL_PACK_BUFFER, buffer_.id());
    const size_t rowBytes = BYTES_PER_PIXEL * width_;
    const auto* pixels = static_cast<const uint8_t*>(
        glMapBufferRange(GL_PIXEL_PACK_BUFFER, 0, static_cast<GLsizeiptr>(rowBytes * height_), GL_MAP_READ_BIT));
    if (pixels == nullptr) throw RunError("the picture cannot be read back: the device is out of memory");
    Image image{width_, height_, std::vector<uint8_t>(size_t{3} * width_ * height_)};
    uint8_t* out = image.rgb.data();
    // GL's first row is the lowest.
    for (uint32_t y = height_; y-- > 0;) {
        const uint8_t* in = pixels + y * rowBytes;
        for (uint32_t x = 0; x < width_; ++x, in += BYTES_PER_PIXEL, out += 3) {
            out[0] = in[0];
            out[1] = in[1];
            out[2] = in[2];
        }
    }
    if (hasAlpha_)
        for (uint32_t y = height_; y-- > 0;)
            for (uint32_t x = 0; x < width_; ++x) image.alpha.push_back(pixels[y * rowBytes + BYTES_PER_PIXEL * x + 3]);
    glUnmapBuffer(GL_PIXEL_PACK_BUFFER);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    divideByAlpha(image);
    return image;
}

}  // namespace knuckle
