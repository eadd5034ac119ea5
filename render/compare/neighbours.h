#pragma once

#include <algorithm>
#include <cmath>

#include "render/compare/differences.h"

namespace knuckle {

/// A channel's value in steps of 255. What is no number counts as 0, what is huge as 10,000.
inline double inSteps(float value)
{
    return std::isnan(value) ? 0.0 : std::clamp(static_cast<double>(value) * static_cast<double>(STEPS), -1e4, 1e4);
}

/// How far a channel of a pixel of `picture` lies outside of those of the 3 x 3 pixels at the same place in `other`
/// [steps]. Between them is what another driver, or a move by less than a pixel, may make of an edge.
inline double outsideNeighbours(const Picture& picture, const Picture& other, uint32_t x, uint32_t y, size_t c)
{
    const double value = inSteps(picture.rgba[(static_cast<size_t>(y) * picture.width + x) * 4 + c]);
    double low = 1e30, high = -1e30;
    for (uint32_t v = y - (y > 0 ? 1 : 0); v <= std::min(y + 1, picture.height - 1); ++v)
        for (uint32_t u = x - (x > 0 ? 1 : 0); u <= std::min(x + 1, picture.width - 1); ++u) {
            const double neighbour = inSteps(other.rgba[(static_cast<size_t>(v) * picture.width + u) * 4 + c]);
            low = std::min(low, neighbour);
            high = std::max(high, neighbour);
        }
    return std::max({0.0, low - value, value - high});
}

}  // namespace knuckle
