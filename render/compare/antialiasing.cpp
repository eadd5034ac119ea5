#include "render/compare/antialiasing.h"

#include <algorithm>
#include <cmath>

#include "render/compare/neighbours.h"

namespace knuckle {

namespace {

/// Pixels that differ by no more steps than this are the same: dithering, rounding.
constexpr float SAME = 1.01f;
/// So many steps a pixel may lie outside of its neighbours in the other picture.
constexpr double SLACK = 2.0;
/// So many neighbours are the same in a flat area, and no more than so many along an edge.
constexpr int FLAT = 3, ALONG_EDGE = 2;

const float* pixelAt(const Picture& picture, uint32_t x, uint32_t y)
{
    return &picture.rgba[(static_cast<size_t>(y) * picture.width + x) * 4];
}

float lumaOf(const float* pixel)
{
    return STEPS * (0.299f * pixel[0] + 0.587f * pixel[1] + 0.114f * pixel[2] + pixel[3]);
}

/// Calls act(x, y) for the neighbours that there are. @returns how many of the eight lie outside.
template <typename Act>
int forNeighbours(const Picture& picture, uint32_t x, uint32_t y, const Act& act)
{
    int inside = 0;
    for (uint32_t v = y - (y > 0 ? 1 : 0); v <= std::min(y + 1, picture.height - 1); ++v)
        for (uint32_t u = x - (x > 0 ? 1 : 0); u <= std::min(x + 1, picture.width - 1); ++u)
            if (u != x || v != y) {
                act(u, v);
                ++inside;
            }
    return 8 - inside;
}

bool isFlat(const Picture& picture, uint32_t x, uint32_t y)
{
    const float* pixel = pixelAt(picture, x, y);
    int same = 0;
    const int outside = forNeighbours(picture, x, y, [&](uint32_t u, uint32_t v) {
        same += pixelDifference(pixel, pixelAt(picture, u, v)) < SAME ? 1 : 0;
    });
    return same + (outside > 0 ? 1 : 0) >= FLAT;
}

bool isEdgePixel(const Picture& picture, const Picture& other, uint32_t x, uint32_t y)
{
    struct Extreme {
        float change = 0.0f;
        uint32_t x = 0, y = 0;
    };
    Extreme darkest, brightest;
    const float* pixel = pixelAt(picture, x, y);
    const float luma = lumaOf(pixel);
    int same = 0;
    const int outside = forNeighbours(picture, x, y, [&](uint32_t u, uint32_t v) {
        const float* neighbour = pixelAt(picture, u, v);
        if (pixelDifference(pixel, neighbour) < SAME) {
            ++same;
            return;
        }
        const float change = lumaOf(neighbour) - luma;
        if (change < darkest.change) darkest = {change, u, v};
        if (change > brightest.change) brightest = {change, u, v};
    });
    if (same + (outside > 0 ? 1 : 0) > ALONG_EDGE || darkest.change >= 0.0f || brightest.change <= 0.0f) return false;
    const auto flatInBoth = [&](const Extreme& place) {
        return isFlat(picture, place.x, place.y) && isFlat(other, place.x, place.y);
    };
    return flatInBoth(darkest) || flatInBoth(brightest);
}

}  // namespace

bool isAntialiasedEdge(const Picture& a, const Picture& b, uint32_t x, uint32_t y)
{
    for (size_t c = 0; c < 4; ++c)
        if (outsideNeighbours(a, b, x, y, c) > SLACK || outsideNeighbours(b, a, x, y, c) > SLACK) return false;
    return isEdgePixel(a, b, x, y) || isEdgePixel(b, a, x, y);
}

}  // namespace knuckle
