#pragma once

#include "render/compare/differences.h"

namespace knuckle {

/// The tile of a picture in which two pictures differ most.
///
/// Tiles are squares of 8, 16, 32 and 64 pixels that overlap by half. A tile's score is the mean over its pixels and
/// colours of what a pixel differs by beyond 2 of 255 and beyond what its neighbours in the other picture explain: a
/// value between the smallest and the largest of the 3 x 3 pixels there is what another driver may make of an edge. For
/// tiles of 32 and 64 the mean of b - a itself, beyond 1 of 255, counts as well where it is more: a picture that has
/// become a little brighter differs by little in each pixel, but everywhere in the same direction. Scores are
/// multiplied by the root of size / 8, since less is needed to be seen where it is larger.
struct TileDifference {
    double score = 0.0;  ///< 0-255 for tiles of 8.
    PixelBox box;        ///< Of the worst one, the first of equal ones; empty where the score is 0.
};

/// @param a, b of one size. @param marks of Differences, by which equal parts are skipped.
TileDifference findWorstTile(const Picture& a, const Picture& b, const std::vector<uint8_t>& marks, unsigned threads);

}  // namespace knuckle
