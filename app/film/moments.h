#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "app/scene/scene_file.h"

namespace knuckle {

/// A moment that a frame is exposed to.
struct Moment {
    double place = 0.0;  ///< Share of the way from the frame before.
    double time = 0.0;   ///< Of the film [s], not before the frame's shot.
};

/// Those before a frame's own time, in order, spread evenly from when the shutter opens; none without a shutter.
/// @param frame beyond the first.
std::vector<Moment> momentsBefore(const Scene& scene, uint64_t frame);

/// Which of drawsOf() a frame's own moment is: the last; none: all of them are. @param first frame of the run.
std::optional<uint32_t> ownDraw(const Scene& scene, uint64_t frame, uint64_t first);

}  // namespace knuckle
