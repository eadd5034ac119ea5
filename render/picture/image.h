#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace knuckle {

/// Text chunks of a PNG file: keywords of up to 79 letters of Latin, and their texts in UTF-8.
using PngText = std::vector<std::pair<std::string, std::string>>;

/// 8-bit sRGB pixels, top row first.
struct Image {
    uint32_t width = 0, height = 0;
    std::vector<uint8_t> rgb = {};    ///< width * height * 3
    PngText text = {};                ///< Of its file; not read back.
    std::vector<uint16_t> deep = {};  ///< The same as rgb in 16 bits a channel; empty: there is no more than rgb.
    std::vector<uint8_t> alpha = {};  ///< width * height; empty: opaque. Colours are not times it. Not read back.
};

/// @throws InputError (missing, not an image) or RunError (disk full; nothing is left half-written).
Image readImage(const std::string& path);
void writePng(const std::string& path, const Image& image);

/// Quick: frames are written once and viewed, and small files would take several times as long.
enum class PngEffort { Quick, Small };

/// The bytes of a PNG file.
std::string pngOf(const Image& image, PngEffort effort = PngEffort::Quick);
/// The bytes of a JPEG file, without its text. @param quality 1 to 100; above 90 colours have the full resolution.
std::string jpegOf(const Image& image, int quality);
/// The bytes of a PNG file of raw pixels. @param channels 3: RGB, 4: with alpha. @param pixels width * height *
/// channels, top row first.
std::string encodePng(uint32_t width, uint32_t height, uint32_t channels, std::span<const uint8_t> pixels);

/// The grey values of an image, 0 ... 1, top row first, as stored in its file: gamma is not removed.
struct GreyImage {
    uint32_t width = 0, height = 0;
    std::vector<float> values;  ///< width * height
};

/// 8 or 16 bits a channel; the luminance of a coloured image. @throws InputError as readImage() does.
GreyImage readGreyImage(const std::string& path);

}  // namespace knuckle
