#pragma once

#include <string>

#include "render/picture/image.h"

namespace knuckle {

/// The bytes of a PNG file with 16 bits a channel. @param image must have Image::deep.
std::string deepPngOf(const Image& image);

/// The bytes of an OpenEXR file: linear light as half floats, packed by ZIP. What the display shows at its brightest is
/// 1; with an alpha, colours are multiplied by it. @param image must have Image::deep.
std::string exrOf(const Image& image);

}  // namespace knuckle
