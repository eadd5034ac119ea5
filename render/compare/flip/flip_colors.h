#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

/// FLIP's colour spaces, for single colours.
namespace knuckle {

using Color = std::array<float, 3>;

/// Linear sRGB to CIE XYZ, as ratios of integers from the primaries and the white of sRGB.
constexpr std::array<std::array<double, 3>, 3> XYZ_OF_RGB{
    {{10135552.0 / 24577794.0, 8788810.0 / 24577794.0, 4435075.0 / 24577794.0},
     {2613072.0 / 12288897.0, 8788810.0 / 12288897.0, 887015.0 / 12288897.0},
     {1425312.0 / 73733382.0, 8788810.0 / 73733382.0, 70074185.0 / 73733382.0}}};
/// Its inverse, to as many digits as a float holds.
constexpr std::array<std::array<double, 3>, 3> RGB_OF_XYZ{{{3.241003275, -1.537398934, -0.498615861},
                                                           {-0.969224334, 1.875930071, 0.041554224},
                                                           {0.055639423, -0.204011202, 1.057148933}}};
/// XYZ of white, the sums of the matrix' rows.
constexpr std::array<double, 3> WHITE{XYZ_OF_RGB[0][0] + XYZ_OF_RGB[0][1] + XYZ_OF_RGB[0][2],
                                      XYZ_OF_RGB[1][0] + XYZ_OF_RGB[1][1] + XYZ_OF_RGB[1][2],
                                      XYZ_OF_RGB[2][0] + XYZ_OF_RGB[2][1] + XYZ_OF_RGB[2][2]};

/// Linear RGB to XYZ as shares of white.
inline Color relativeXyz(const Color& rgb)
{
    Color xyz{};
    for (size_t i = 0; i < 3; ++i) {
        const double scale = 1.0 / WHITE[i];
        xyz[i] = static_cast<float>(XYZ_OF_RGB[i][0] * scale) * rgb[0] +
                 static_cast<float>(XYZ_OF_RGB[i][1] * scale) * rgb[1] +
                 static_cast<float>(XYZ_OF_RGB[i][2] * scale) * rgb[2];
    }
    return xyz;
}

/// Linear RGB to the opponent space YCxCz: brightness, red-green, blue-yellow, all linear.
inline Color opponentOfRgb(const Color& rgb)
{
    const Color xyz = relativeXyz(rgb);
    return {116.0f * xyz[1] - 16.0f, 500.0f * (xyz[0] - xyz[1]), 200.0f * (xyz[1] - xyz[2])};
}

inline Color rgbOfOpponent(const Color& opponent)
{
    const float y = (opponent[0] + 16.0f) / 116.0f;
    const Color xyz{y + opponent[1] / 500.0f, y, y - opponent[2] / 200.0f};
    Color rgb{};
    for (size_t i = 0; i < 3; ++i)
        rgb[i] = static_cast<float>(RGB_OF_XYZ[i][0] * WHITE[0]) * xyz[0] +
                 static_cast<float>(RGB_OF_XYZ[i][1] * WHITE[1]) * xyz[1] +
                 static_cast<float>(RGB_OF_XYZ[i][2] * WHITE[2]) * xyz[2];
    return rgb;
}

/// To the last bit but one, and unlike std::cbrt without a call, so that a row of pixels is worked on at once.
/// @param x above 0.
inline float cubeRoot(float x)
{
    // A third of the exponent, and of what follows it, is near the root; Halley's steps triple the right digits.
    float root = std::bit_cast<float>(std::bit_cast<int32_t>(x) / 3 + 0x2a514067);
    for (int step = 0; step < 2; ++step) {
        const float cube = root * root * root;
        root *= (cube + 2.0f * x) / (2.0f * cube + x);
    }
    return root;
}

/// Linear RGB to CIELAB with the Hunt effect: colours of dark pixels count less.
inline Color huntLabOfRgb(const Color& rgb)
{
    constexpr float DELTA = 6.0f / 29.0f;
    Color xyz = relativeXyz(rgb);
    for (float& part : xyz) {
        const float root = cubeRoot(std::max(part, 1e-6f));
        part = part > DELTA * DELTA * DELTA ? root : part / (3.0f * DELTA * DELTA) + 4.0f / 29.0f;
    }
    const float lightness = 116.0f * xyz[1] - 16.0f;
    return {lightness, 0.01f * lightness * 500.0f * (xyz[0] - xyz[1]), 0.01f * lightness * 200.0f * (xyz[1] - xyz[2])};
}

/// The HyAB distance: of lightness, and of colour, added.
inline float hyabDistance(const Color& a, const Color& b)
{
    const float green = a[1] - b[1], blue = a[2] - b[2];
    return std::fabs(a[0] - b[0]) + std::sqrt(green * green + blue * blue);
}

}  // namespace knuckle
