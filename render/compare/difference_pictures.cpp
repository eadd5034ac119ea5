#include "render/compare/difference_pictures.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace knuckle {

namespace {

constexpr std::array<std::array<float, 3>, 9> HEAT{{{0, 0, 4},
                                                    {28, 16, 68},
                                                    {79, 18, 123},
                                                    {129, 37, 129},
                                                    {181, 54, 122},
                                                    {229, 80, 100},
                                                    {251, 135, 97},
                                                    {254, 194, 135},
                                                    {252, 253, 191}}};

uint8_t byteOf(float value)
{
    return static_cast<uint8_t>(std::clamp(value + 0.5f, 0.0f, 255.0f));
}

}  // namespace

const std::array<std::array<float, 3>, 9>& heatColors()
{
    return HEAT;
}

Image differencePicture(const Picture& first, const Picture& second, const PictureComparison& comparison)
{
    Image image{first.width, first.height, std::vector<uint8_t>(first.pixelCount() * 3)};
    for (size_t i = 0; i < first.pixelCount(); ++i) {
        if (comparison.differences.marks[i] == 0) continue;
        const auto difference = [&](size_t c) {
            const float steps = std::fabs(first.rgba[i * 4 + c] - second.rgba[i * 4 + c]) * STEPS * DIFFERENCE_GAIN;
            return std::isfinite(steps) ? steps : 255.0f;
        };
        for (size_t c = 0; c < 3; ++c) image.rgb[i * 3 + c] = byteOf(std::max(difference(c), difference(3)));
    }
    return image;
}

Image heatmapPicture(const PictureComparison& comparison)
{
    const size_t pixels = static_cast<size_t>(comparison.width) * comparison.height;
    Image image{comparison.width, comparison.height, std::vector<uint8_t>(pixels * 3)};
    for (size_t i = 0; i < pixels; ++i) {
        const float error = comparison.flip.errors.empty() ? 0.0f : comparison.flip.errors[i];
        const float place = std::clamp(error, 0.0f, 1.0f) * static_cast<float>(HEAT.size() - 1);
        const size_t step = std::min(HEAT.size() - 2, static_cast<size_t>(place));
        const float rest = place - static_cast<float>(step);
        for (size_t c = 0; c < 3; ++c)
            image.rgb[i * 3 + c] = byteOf(HEAT[step][c] + rest * (HEAT[step + 1][c] - HEAT[step][c]));
    }
    return image;
}

}  // namespace knuckle
