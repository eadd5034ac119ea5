#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "sim/world/matter/skin.h"

namespace knuckle {

/// Sides up to which pictures are decoded [pixels].
inline constexpr int DECODED_SIDE = 8192;

/// A picture of the kinds PNG, JPEG, TGA, BMP and PSD, in the size that it has.
/// @returns nothing for bytes that are damaged, of another kind, or larger than DECODED_SIDE.
std::optional<TexturePicture> decodeTexture(std::span<const uint8_t> bytes);

}  // namespace knuckle
