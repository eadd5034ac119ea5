#pragma once

#include <cstdint>
#include <string>

#include "app/scene/scene_file.h"

namespace knuckle {

/// First and last frame to draw.
struct FrameRange {
    uint64_t first = 0, last = 0;  ///< 0: the scene's first or last.

    /// Reads "A:B", "A:", ":B" or "A". @throws InputError.
    static FrameRange parse(const std::string& text);
    /// With both known. @param begin the scene's first frame. @throws InputError for frames that the scene does not
    /// have.
    FrameRange of(const Scene& scene, uint64_t begin) const;
};

}  // namespace knuckle
