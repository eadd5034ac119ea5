#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace knuckle {

/// A picture of any origin, as it is to be seen: four floats a pixel, red, green, blue and alpha, top row first.
///
/// Colours are sRGB-encoded and multiplied by alpha, so that what is fully transparent is black, and adding
/// (1 - alpha) times a background shows the picture on it. 0 to 1 in ordinary pictures; in `hdr` ones the sRGB curve
/// goes on above 1, and below 0 as its mirror image.
struct Picture {
    uint32_t width = 0, height = 0;
    std::vector<float> rgba;                  ///< width * height * 4
    uint32_t bitDepth = 8;                    ///< Of a channel in the file: 1 to 32.
    bool hdr = false;                         ///< From a format of linear light without bounds (EXR).
    bool hasAlpha = false;                    ///< Else alpha is 1 everywhere.
    std::map<std::string, std::string> text;  ///< Of PNG's tEXt, zTXt and iTXt, of JPEG's comment: UTF-8, by keyword.

    size_t pixelCount() const { return static_cast<size_t>(width) * height; }
};

/// The sRGB curve for any value: above 1 it goes on, below 0 it is mirrored. @param linear light.
float encodeSrgb(float linear);
/// The inverse.
float decodeSrgb(float encoded);

}  // namespace knuckle
