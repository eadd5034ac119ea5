#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace knuckle::test {

/// What a PNG file is to hold. Samples are the file's own, packed for fewer than 8 bits, big-endian for 16.
struct PngMade {
    uint32_t width = 1, height = 1;
    int bits = 8, type = 2;  ///< libpng's colour type: 0 grey, 2 RGB, 3 palette, 4 grey with alpha, 6 RGBA.
    std::vector<std::vector<uint8_t>> rows;
    std::vector<std::array<uint8_t, 3>> palette = {};
    std::vector<uint8_t> paletteAlpha = {};
    int clearGrey = -1;  ///< The grey value that is transparent.
    bool interlaced = false, srgb = false;
    double gamma = 0.0;
    std::vector<std::pair<std::string, std::string>> latinText = {}, unicodeText = {};
};

/// The bytes of the file, by libpng.
std::string pngBytes(const PngMade& made);
/// An RGB file whose pixels are all different.
PngMade anyRgb(uint32_t width, uint32_t height);

/// @param samples width * height * parts bytes: 1 grey, 3 RGB.
std::string jpegBytes(uint32_t width, uint32_t height, int parts, const std::vector<uint8_t>& samples);

/// What an EXR file is to hold: channels by name with linear values of the data window.
struct ExrMade {
    int left = 0, top = 0, width = 1, height = 1;  ///< The data window.
    int shownWidth = 0, shownHeight = 0;           ///< The display window, from 0, 0; 0: as the data window.
    bool half = false, tiled = false;
    std::vector<std::pair<std::string, std::vector<float>>> channels = {};
};
std::string exrBytes(const ExrMade& made);

}  // namespace knuckle::test
