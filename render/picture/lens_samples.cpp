#include "render/picture/lens_samples.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace knuckle {

namespace {

/// The digits of a number after the point instead of before it (J. van der Corput 1935).
double mirrored(uint32_t number)
{
    double value = 0.0, digit = 0.5;
    for (; number != 0; number >>= 1, digit *= 0.5) value += digit * (number & 1u);
    return value;
}

/// Another order of `count` numbers: a step about `share` of them that meets all.
uint32_t shuffled(uint32_t number, uint32_t count, double share)
{
    auto step = static_cast<uint32_t>(std::max(1.0, std::round(share * count)));
    while (std::gcd(step, count) != 1) ++step;
    return number * step % count;
}

double meanMirrored(uint32_t count)
{
    double sum = 0.0;
    for (uint32_t k = 0; k < count; ++k) sum += mirrored(k);
    return sum / count;
}

}  // namespace

LensSample lensSample(uint32_t draw, uint32_t count)
{
    if (count < 2) return {};
    const uint32_t pixel = shuffled(draw, count, 0.618), lens = shuffled(draw, count, 0.382);
    // Sunflower seeds (H. Vogel 1979).
    const double radius = std::sqrt((lens + 0.5) / count), angle = lens * std::numbers::pi * (3.0 - std::sqrt(5.0));
    return {static_cast<float>((pixel + 0.5) / count - 0.5), static_cast<float>(mirrored(pixel) - meanMirrored(count)),
            static_cast<float>(radius * std::cos(angle)), static_cast<float>(radius * std::sin(angle))};
}

}  // namespace knuckle
