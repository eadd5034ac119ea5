#include "render/color_word.h"

#include <array>
#include <cmath>

#include "sim/base/colors.h"

namespace knuckle {

namespace {

/// The square root of the light of an sRGB byte, 0 to 255.
uint8_t rootOfLight(uint8_t value)
{
    static const std::array<uint8_t, 256> ROOTS = [] {
        std::array<uint8_t, 256> roots;
        for (size_t i = 0; i < roots.size(); ++i) {
            const double light = linearOfSrgb(static_cast<double>(i) / 255.0);
            roots[i] = static_cast<uint8_t>(std::lround(255.0 * std::sqrt(light)));
        }
        return roots;
    }();
    return ROOTS[value];
}

uint32_t word(uint32_t red, uint32_t green, uint32_t blue, uint32_t alpha)
{
    return red | green << 8 | blue << 16 | alpha << 24;
}

}  // namespace

uint32_t packColor(const Vector3f& color)
{
    const Eigen::Array3f root = (color.array().max(0.0f).min(1.0f).sqrt() * 255.0f).round();
    return word(static_cast<uint32_t>(root.x()), static_cast<uint32_t>(root.y()), static_cast<uint32_t>(root.z()), 255);
}

Vector3f unpackColor(uint32_t word)
{
    const auto light = [](uint32_t byte) {
        const float root = static_cast<float>(byte & 255u) / 255.0f;
        return root * root;
    };
    return {light(word), light(word >> 8), light(word >> 16)};
}

uint32_t packPixel(const uint8_t* srgba)
{
    return word(rootOfLight(srgba[0]), rootOfLight(srgba[1]), rootOfLight(srgba[2]), srgba[3]);
}

}  // namespace knuckle
