#pragma once

#include <cstddef>

#include "render/compare/differences.h"

namespace knuckle {

/// A connected region of changed pixels.
struct DifferencePlace {
    PixelBox box;
    uint64_t pixels = 0;  ///< Changed ones in it.
};

/// Regions are joined across gaps of this many pixels.
constexpr uint32_t PLACE_GAP = 4;
/// The largest regions are listed, the others counted.
constexpr size_t MOST_LISTED_PLACES = 100;

/// The regions of changed pixels, those with most pixels first, of equal ones the upper, then the left one.
/// @param marks of Differences. @param least a pixel counts from this mark on.
std::vector<DifferencePlace> findPlaces(const std::vector<uint8_t>& marks, uint32_t width, uint32_t height,
                                        uint8_t least);

}  // namespace knuckle
