#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "render/reader/picture.h"

namespace knuckle {

/// All differences are in steps of 8-bit channels, so that 255 is from black to white, whatever the pictures' depth.
constexpr float STEPS = 255.0f;

/// A rectangle of pixels, the place of its top left one and its size.
struct PixelBox {
    uint32_t x = 0, y = 0, width = 0, height = 0;
};

struct ChannelDifference {
    double max = 0.0, mean = 0.0;  ///< Of |a - b|, 0-255; not bounded in HDR pictures.
};

/// What two pictures of one size differ by, pixel for pixel.
struct Differences {
    std::array<ChannelDifference, 4> channels;  ///< Red, green, blue, alpha; colours multiplied by alpha.
    double mean = 0.0;                          ///< Over red, green, blue, and alpha where one of the pictures has it.
    double max = 0.0;                           ///< The largest of all channels.
    uint64_t differing = 0;                     ///< Pixels that are not the same to the last bit.
    uint64_t changed = 0;                       ///< Pixels of which a channel differs by more than the threshold.
    std::vector<uint8_t> marks;                 ///< Per pixel: 0 the same, 1 differing, 2 changed; width * height.
};

/// The larger of the differences of a pixel's four channels; not a number against itself is none, against a number the
/// largest there is. @param a, b four floats.
float pixelDifference(const float* a, const float* b);

/// @param a, b of one size. @param threshold 0-255. @param compared pixels, over which means are taken.
Differences findDifferences(const Picture& a, const Picture& b, float threshold, uint64_t compared, unsigned threads);

}  // namespace knuckle
