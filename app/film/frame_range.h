#pragma once

#include <cstdint>
#include <string>

#include "app/scene/scene_file.h"

namespace knuckle {

/// First and last frame to draw, and which of those between.
struct FrameRange {
    uint64_t first = 0, last = 0;  ///< 0: the scene's first or last.
    uint64_t stride = 1;           ///< From one frame to the next.
    bool onlyLast = false;         ///< Of all, whichever it is.

    /// Whether the frame is drawn.
    bool has(uint64_t frame) const { return first <= frame && frame <= last && (frame - first) % stride == 0; }
    /// Of a drawn frame, from 0.
    uint64_t indexOf(uint64_t frame) const { return (frame - first) / stride; }
    /// How many are drawn.
    uint64_t count() const { return indexOf(last) + 1; }
    /// The last that is drawn.
    uint64_t lastDrawn() const { return last - (last - first) % stride; }

    /// Reads "A:B", "A:", ":B", "A" or "last". @throws InputError.
    static FrameRange parse(const std::string& text);
    /// With both known. @param begin the scene's first frame. @throws InputError for frames that the scene does not
    /// have.
    FrameRange of(const Scene& scene, uint64_t begin) const;
};

}  // namespace knuckle
