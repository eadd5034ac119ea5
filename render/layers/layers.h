#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

#include "render/settings.h"
#include "shared/thing_types.h"
#include "shared/vector_types.h"

namespace knuckle {

/// Where a picture was taken from, without a lens: a point at (x, y, z) of the camera's axes (right, up, back; z below
/// 0) is at column width / 2 + focal * x / -z and row height / 2 - focal * y / -z, counted from the upper left corner.
struct LayerCamera {
    Eigen::Isometry3d toWorld = Eigen::Isometry3d::Identity();  ///< From the camera's axes [m].
    double focal = 1.0;                                         ///< [pixels]
};

/// What a frame's pixels show, as numbers; top row first. One sample a pixel, at its middle.
struct Layers {
    uint32_t width = 0, height = 0;
    std::vector<gpu::vec4> places;   ///< xyz: normal in the world, unit; w: depth along the camera's axis [m], below 0
                                     ///< where nothing is.
    std::vector<gpu::vec4> albedo;   ///< rgb, linear.
    std::vector<gpu::uvec2> things;  ///< THING_*, its index in the World.
    std::vector<gpu::vec4> earlier;  ///< xyz: the place in the world of the frame before [m], if w is 1; else it moves
                                     ///< with the thing.
    LayerCamera camera;
};

/// For pictures as numbers: of the same cameras, at their size, with one sample, and without all that is blurred,
/// mixed or written over a picture. Of two cameras that share a picture the first, whole. Where colours show a
/// quantity, each particle has a colour of its own.
RenderSettings layerSettings(const RenderSettings& settings);

}  // namespace knuckle
