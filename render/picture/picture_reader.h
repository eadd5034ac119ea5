#pragma once

#include <cstdint>

#include "render/picture/image.h"
#include "sim/gpu/gl_handle.h"

namespace knuckle {

/// Reads pictures back through a pixel buffer, so that the copy can run during the simulation of the next steps.
class PictureReader {
public:
    /// @param hasAlpha  Whether pictures have an alpha that their colours are multiplied by.
    /// @param depth  Bits of a channel, 8 or 16 (Image::deep).
    PictureReader(uint32_t width, uint32_t height, bool hasAlpha, uint32_t depth = 8);

    /// Starts the copy of the whole `framebuffer`.
    void start(GLuint framebuffer);
    /// The picture of the last start(); waits for it. @throws RunError before any.
    Image last();

private:
    size_t bytes() const;
    template <typename Channel>
    void fill(Image& image, const Channel* pixels) const;

    uint32_t width_, height_;
    bool hasAlpha_, isDeep_;
    BufferHandle buffer_;
    bool started_ = false;
};

}  // namespace knuckle
