#include "render/compare/ignored.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/base/errors.h"

namespace knuckle {

namespace {

/// Half a step of 8-bit channels.
constexpr float HALF_STEP = 0.5f / STEPS;

bool hasColor(const float* pixel, const std::array<uint8_t, 3>& color)
{
    for (size_t c = 0; c < 3; ++c)
        if (!(std::fabs(pixel[c] - static_cast<float>(color[c]) / STEPS) < HALF_STEP)) return false;
    return pixel[3] > 1.0f - HALF_STEP;
}

void ignoreBox(const PixelBox& box, const Picture& picture, std::vector<uint8_t>& ignored)
{
    const uint64_t right = std::min<uint64_t>(picture.width, uint64_t{box.x} + box.width);
    const uint64_t bottom = std::min<uint64_t>(picture.height, uint64_t{box.y} + box.height);
    for (uint64_t y = box.y; y < bottom; ++y)
        for (uint64_t x = box.x; x < right; ++x) ignored[y * picture.width + x] = 1;
}

void ignoreMasked(const Picture& mask, const Picture& picture, std::vector<uint8_t>& ignored)
{
    if (mask.width != picture.width || mask.height != picture.height)
        throw InputError(fmt::format("the mask has {} x {} pixels, the images {} x {}; make it as large as they are",
                                     mask.width, mask.height, picture.width, picture.height));
    for (size_t i = 0; i < ignored.size(); ++i) {
        const float* pixel = &mask.rgba[i * 4];
        // Colours are multiplied by alpha, so that black and transparent are one.
        if (std::max({pixel[0], pixel[1], pixel[2]}) < HALF_STEP) ignored[i] = 1;
    }
}

}  // namespace

std::vector<uint8_t> findIgnored(const Picture& a, const Picture& b, const IgnoredParts& parts)
{
    if (!parts.any()) return {};
    std::vector<uint8_t> ignored(a.pixelCount());
    for (const PixelBox& box : parts.boxes) ignoreBox(box, a, ignored);
    if (parts.mask) ignoreMasked(*parts.mask, a, ignored);
    for (size_t i = 0; i < ignored.size(); ++i)
        for (const auto& color : parts.colors)
            if (hasColor(&a.rgba[i * 4], color) || hasColor(&b.rgba[i * 4], color)) ignored[i] = 1;
    if (std::ranges::all_of(ignored, [](uint8_t value) { return value != 0; }))
        throw InputError("nothing is left to compare: all pixels are ignored; ignore less");
    return ignored;
}

}  // namespace knuckle
