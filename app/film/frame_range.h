#pragma once

#include <cstdint>
#include <string>

#include "app/scene/scene_file.h"

namespace knuckle {

/// First and last frame to draw, from 1.
struct FrameRange {
    uint64_t first = 1, last = 0;  ///< last 0: the scene's last.

    /// Reads "A:B", "A:", ":B" or "A". @throws InputError.
    static FrameRange parse(const std::string& text);
    /// With the last frame known. @throws InputError for frames that the scene does not have.
    FrameRange of(const Scene& scene) const;
};

}  // namespace knuckle
