#pragma once

#include <epoxy/gl.h>

#include <cstdint>
#include <optional>

#include "render/image.h"

namespace knuckle {

/// Brings pictures back through two pixel buffers in turn, so that a copy can run while the next frame is made.
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
    /// The picture of the start() before the last, once.
    std::optional<Image> previous();

private:
    Image map(GLuint buffer) const;

    uint32_t width_, height_;
    GLuint buffers_[2] = {0, 0};
    uint32_t current_ = 0;
    uint64_t started_ = 0;
    bool previousWaits_ = false;     ///< The one before the last has not been handed out.
};

}  // namespace knuckle
