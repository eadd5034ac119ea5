#pragma once

#include <epoxy/gl.h>

#include <cstdint>

#include "render/picture/image.h"

namespace knuckle {

/// Brings pictures back through a pixel buffer, so that the copy can run while the next steps are simulated.
class PictureReader {
public:
    PictureReader(uint32_t width, uint32_t height);
    ~PictureReader();
    PictureReader(const PictureReader&) = delete;
    PictureReader& operator=(const PictureReader&) = delete;

    /// Starts the copy of the whole `framebuffer`.
    void start(GLuint framebuffer);
    /// The picture of the last start(); waits for it. @throws RunError before any.
    Image last();

private:
    uint32_t width_, height_;
    GLuint buffer_ = 0;
    bool started_ = false;
};

}  // namespace knuckle
