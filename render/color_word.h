#pragma once

#include <cstdint>

#include "sim/world/world.h"

namespace knuckle {

/// The colour in a word of packColor(), without its alpha: a number that floats represent exactly.
inline constexpr uint32_t COLOR_BITS = 0xFFFFFF;

/// A colour, linear RGB of 0 to 1, as a word of square roots, like packAlbedo() of shaders/render/common/surface.glsl;
/// opaque.
uint32_t packColor(const Vector3f& color);
Vector3f unpackColor(uint32_t word);

/// The word of a pixel. @param srgba its bytes: sRGB, alpha.
uint32_t packPixel(const uint8_t* srgba);

}  // namespace knuckle
