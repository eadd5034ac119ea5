#pragma once

#include <cstdint>
#include <string_view>

namespace knuckle {

/// Whether these are the bytes of a whole PNG (by the checksums of its chunks) or JPEG (by its end) of that size.
bool isWholePicture(std::string_view bytes, uint32_t width, uint32_t height);

}  // namespace knuckle
