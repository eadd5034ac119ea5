#pragma once

#include "render/compare/differences.h"
#include "render/compare/flip/flip.h"
#include "render/compare/ignored.h"
#include "render/compare/places.h"
#include "render/compare/ssim.h"
#include "render/compare/tiles.h"
#include "render/picture/image.h"

namespace knuckle {

/// How two pictures are compared.
struct CompareSettings {
    float threshold = 8.0f;  ///< A pixel has changed where a channel differs by more, 0-255.
    IgnoredParts ignored;
    bool ignoreAntialiasing = false;  ///< Pixels by isAntialiasedEdge() count as equal.
    FlipSettings flip;                ///< Its background serves SSIM as well.
    bool withFlip = true, withSsim = true;
    unsigned threads = 0;  ///< 0: one for each core. Figures do not depend on it.
};

/// What two pictures differ by. Where they have another size, only sizes are told.
struct PictureComparison {
    uint32_t width = 0, height = 0;              ///< Of the first one.
    uint32_t secondWidth = 0, secondHeight = 0;  ///< Of the second one.
    uint64_t compared = 0;                       ///< Pixels that were not ignored.
    uint64_t antialiased = 0;                    ///< Changed ones that count as equal by `ignoreAntialiasing`.
    float threshold = 0.0f;                      ///< As in the settings.
    bool hdr = false;                            ///< FLIP is HDR-FLIP.
    Differences differences;
    TileDifference tile;
    std::vector<DifferencePlace> places;  ///< Of changed pixels; if none has changed, of differing ones.
    FlipResult flip;                      ///< All 0 without `withFlip`.
    SsimResult ssim;                      ///< All 1 without `withSsim`.

    bool sameSize() const { return width == secondWidth && height == secondHeight; }
    bool identical() const { return sameSize() && differences.differing == 0; }
};

/// Compares two pictures, the first being the reference. Neither is changed.
/// @throws InputError for a mask of another size, and where all pixels are ignored.
PictureComparison comparePictures(const Picture& first, const Picture& second, const CompareSettings& settings);

/// For two files with the same bytes. @param picture either of them.
PictureComparison identicalPictures(const Picture& picture, const CompareSettings& settings);

/// A picture of a renderer: 8-bit sRGB. @param rgb width * height * 3 bytes, top row first.
Picture pictureOf(uint32_t width, uint32_t height, const std::vector<uint8_t>& rgb);
Picture pictureOf(const Image& image);

}  // namespace knuckle
