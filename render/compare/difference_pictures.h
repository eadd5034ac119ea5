#pragma once

#include <array>

#include "render/compare/comparison.h"
#include "render/picture/image.h"

namespace knuckle {

/// How much brighter differences are shown than they are.
constexpr float DIFFERENCE_GAIN = 8.0f;

/// |first - second| per channel, DIFFERENCE_GAIN times as bright to be seen; where alpha differs more, all channels
/// show that. Black where `comparison` says that pixels count as equal. The pictures are those it was made of, of one
/// size.
Image differencePicture(const Picture& first, const Picture& second, const PictureComparison& comparison);

/// FLIP's errors by heatColors(). @param comparison with FLIP, of one size.
Image heatmapPicture(const PictureComparison& comparison);

/// From black over violet and orange to pale yellow, 0-255 each: from no error to 1 at equal steps, with even growing
/// lightness, so that it reads in grey as well.
const std::array<std::array<float, 3>, 9>& heatColors();

}  // namespace knuckle
