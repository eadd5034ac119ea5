#pragma once

#include <cstdint>

#include "render/reader/picture.h"

namespace knuckle::test {

/// An opaque 8-bit picture. @param color of the pixel at x, y: three steps of 255.
template <typename ColorAt>
Picture madePicture(uint32_t width, uint32_t height, const ColorAt& color)
{
    Picture picture;
    picture.width = width;
    picture.height = height;
    for (uint32_t y = 0; y < height; ++y)
        for (uint32_t x = 0; x < width; ++x) {
            const std::array<int, 3> steps = color(x, y);
            for (const int step : steps) picture.rgba.push_back(static_cast<float>(step) / 255.0f);
            picture.rgba.push_back(1.0f);
        }
    return picture;
}

inline Picture flatPicture(uint32_t width, uint32_t height, std::array<int, 3> color)
{
    return madePicture(width, height, [&](uint32_t, uint32_t) { return color; });
}

inline float* pixelOf(Picture& picture, uint32_t x, uint32_t y)
{
    return &picture.rgba[(static_cast<size_t>(y) * picture.width + x) * 4];
}

inline void setPixel(Picture& picture, uint32_t x, uint32_t y, std::array<int, 3> color)
{
    for (size_t c = 0; c < 3; ++c) pixelOf(picture, x, y)[c] = static_cast<float>(color[c]) / 255.0f;
}

inline void fillBox(Picture& picture, uint32_t left, uint32_t top, uint32_t width, uint32_t height,
                    std::array<int, 3> color)
{
    for (uint32_t y = top; y < top + height; ++y)
        for (uint32_t x = left; x < left + width; ++x) setPixel(picture, x, y, color);
}

}  // namespace knuckle::test
