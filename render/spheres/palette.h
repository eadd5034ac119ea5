#pragma once

#include <cstdint>
#include <vector>

#include "render/settings.h"
#include "sim/world/world.h"

namespace knuckle {

/// OKLCH (B. Ottosson, "A perceptual color space for image processing", 2020) to linear RGB, clipped to 0-1.
/// @param hue [rad]
Vector3f fromOklch(float lightness, float chroma, float hue);

/// The colour number `index` of an endless palette whose neighbours differ: hues a golden section apart.
Vector3f paletteColor(uint32_t index);

/// A word of packColor() for all of a body; 0 if the GPU computes it from the speed. No body has another quantity.
uint32_t bodyColor(const World& world, uint32_t body, const RenderSettings& settings);

/// A word of packColor() per particle; 0 if the GPU computes it from a quantity.
std::vector<uint32_t> particleColors(const World& world, const RenderSettings& settings);

}  // namespace knuckle
