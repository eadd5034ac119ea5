#pragma once

#include <cstdint>
#include <vector>

#include "app/scene/scene_file.h"

namespace knuckle {

/// A moment that a frame is exposed to.
struct Moment {
    double place = 0.0;  ///< Share of the way from the frame before.
    double time = 0.0;   ///< Of the film [s], not before the frame's shot.
};

/// Those before a frame's own time, which is the last of drawsOf(), in order: spread evenly from when the shutter opens.
/// None without a shutter. @param frame beyond the first.
std::vector<Moment> momentsBefore(const Scene& scene, uint64_t frame);

}  // namespace knuckle
