#pragma once

#include <cstdint>

namespace knuckle {

/// Where one of several draws of a frame sees from.
struct LensSample {
    float pixelX = 0.0f, pixelY = 0.0f;  ///< Beside the pixel's middle [pixels], -0.5 ... 0.5.
    float lensX = 0.0f, lensY = 0.0f;    ///< On a lens of radius 1.
};

/// Places that are spread evenly over the pixel and over the lens, neither in the order of time; their mean is the
/// middle of the pixel. @param draw of `count`.
LensSample lensSample(uint32_t draw, uint32_t count);

}  // namespace knuckle
