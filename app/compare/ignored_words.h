#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "render/compare/ignored.h"

namespace knuckle {

/// "X,Y,WxH" in pixels. @param where the option or place that holds the word, for the message. @throws InputError.
PixelBox parseBox(const std::string& where, const std::string& word);

/// "RRGGBB" in hexadecimal, perhaps after a #. @throws InputError.
std::array<uint8_t, 3> parseColor(const std::string& where, const std::string& word);

}  // namespace knuckle
