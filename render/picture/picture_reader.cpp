#include "render/picture/picture_reader.h"

#include <algorithm>

#include "sim/base/errors.h"

namespace knuckle {

namespace {

constexpr size_t CHANNELS = 4;

/// The nearest of 8 bits.
uint8_t shortened(uint32_t channel)
{
    return static_cast<uint8_t>((channel * 255u + 32767u) / 65535u);
}

/// Passes multiply colours by what they cover.
void divideByAlpha(Image& image)
{
    for (size_t i = 0; i < image.alpha.size(); ++i) {
        const uint32_t alpha = image.alpha[i];
        if (alpha == 0 || alpha == 255) continue;
        for (size_t k = 3 * i; k < 3 * i + 3; ++k) {
            image.rgb[k] = static_cast<uint8_t>(std::min((255u * image.rgb[k] + alpha / 2) / alpha, 255u));
            if (image.deep.empty()) continue;
            image.deep[k] = static_cast<uint16_t>(std::min((255u * image.deep[k] + alpha / 2) / alpha, 65535u));
        }
    }
}

}  // namespace

PictureReader::PictureReader(uint32_t width, uint32_t height, bool hasAlpha, uint32_t depth)
    : width_(width), height_(height), hasAlpha_(hasAlpha), isDeep_(depth == 16), buffer_(BufferHandle::make())
{
    glBindBuffer(GL_PIXEL_PACK_BUFFER, buffer_.id());
    glBufferData(GL_PIXEL_PACK_BUFFER, static_cast<GLsizeiptr>(bytes()), nullptr, GL_STREAM_READ);
    glObjectLabel(GL_BUFFER, buffer_.id(), -1, "picture read-back");
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
}

size_t PictureReader::bytes() const
{
    return CHANNELS * (isDeep_ ? sizeof(uint16_t) : sizeof(uint8_t)) * width_ * height_;
}

void PictureReader::start(GLuint framebuffer)
{
    started_ = true;
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer);
    glReadBuffer(GL_COLOR_ATTACHMENT0);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, buffer_.id());
    glReadPixels(0, 0, static_cast<GLsizei>(width_), static_cast<GLsizei>(height_), GL_RGBA,
                 isDeep_ ? GL_UNSIGNED_SHORT : GL_UNSIGNED_BYTE, nullptr);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
}

template <typename Channel>
void PictureReader::fill(Image& image, const Channel* pixels) const
{
    // GL's first row is the lowest.
    size_t out = 0;
    for (uint32_t y = height_; y-- > 0;) {
        const Channel* in = pixels + CHANNELS * y * width_;
        for (uint32_t x = 0; x < width_; ++x, in += CHANNELS)
            for (size_t c = 0; c < 3; ++c, ++out) {
                if constexpr (sizeof(Channel) == 2) {
                    image.deep[out] = in[c];
                    image.rgb[out] = shortened(in[c]);
                } else {
                    image.rgb[out] = in[c];
                }
            }
        if (!hasAlpha_) continue;
        in = pixels + CHANNELS * y * width_;
        for (uint32_t x = 0; x < width_; ++x, in += CHANNELS)
            image.alpha.push_back(sizeof(Channel) == 2 ? shortened(in[3]) : static_cast<uint8_t>(in[3]));
    }
}

Image PictureReader::last()
{
    if (!started_) throw RunError("there is no picture to read: nothing has been drawn yet");
    glBindBuffer(GL_PIXEL_PACK_BUFFER, buffer_.id());
    const void* pixels = glMapBufferRange(GL_PIXEL_PACK_BUFFER, 0, static_cast<GLsizeiptr>(bytes()), GL_MAP_READ_BIT);
    if (pixels == nullptr) throw RunError("the picture cannot be read back: the device is out of memory");
    const size_t channels = size_t{3} * width_ * height_;
    Image image{width_, height_, std::vector<uint8_t>(channels)};
    if (isDeep_) image.deep.resize(channels);
    if (isDeep_) fill(image, static_cast<const uint16_t*>(pixels));
    else fill(image, static_cast<const uint8_t*>(pixels));
    glUnmapBuffer(GL_PIXEL_PACK_BUFFER);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    divideByAlpha(image);
    return image;
}

}  // namespace knuckle
