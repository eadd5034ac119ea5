#pragma once

#include <cstdint>

#include "render/picture/image.h"
#include "sim/gpu/gl_handle.h"

namespace knuckle {

/// Reads pictures back through a pixel buffer, so that the copy can run during the simulation of the next steps.
class PictureReader {
public:
    /// @param hasAlpha  Whether pictures have an alpha that their colours are multiplied by.
    PictureReader(uint32_t width, uint32_t height, bool hasAlpha);

    /// Starts the copy of the whole `framebuffer`.
    void start(GLuint framebuffer);
    /// The picture of the last start(); waits for it. @throws RunError before any.
    Image last();

private:
    uint32_t width_, height_;
    bool hasAlpha_;
    BufferHandle buffer_;
    bool started_ = false;
};

}  // namespace knuckle
