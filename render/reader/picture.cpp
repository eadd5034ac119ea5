#include "render/reader/picture.h"

#include <cmath>

#include "sim/base/colors.h"

namespace knuckle {

float encodeSrgb(float linear)
{
    const float size = std::fabs(linear);
    const float encoded = size <= 0.0031308f ? 12.92f * size : 1.055f * std::pow(size, 1.0f / 2.4f) - 0.055f;
    return std::copysign(encoded, linear);
}

float decodeSrgb(float encoded)
{
    return std::copysign(linearOfSrgb(std::fabs(encoded)), encoded);
}

}  // namespace knuckle
