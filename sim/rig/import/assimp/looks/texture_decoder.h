#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "sim/world/matter/skin.h"

namespace knuckle {

/// Longest sides of pictures that are decoded [pixels].
inline constexpr int DECODED_SIDE = 8192;

/// Decodes a PNG, JPEG, TGA, BMP or PSD picture, in its own size.
/// @returns nothing for bytes that are damaged, of another kind, or larger than DECODED_SIDE.
std::optional<TexturePicture> decodeTexture(std::span<const uint8_t> bytes);

}  // namespace knuckle
