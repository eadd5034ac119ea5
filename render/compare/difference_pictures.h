#pragma once

#include "render/compare/comparison.h"
#include "render/picture/image.h"

namespace knuckle {

/// |first - second| per channel, brightened eightfold to be seen; where alpha differs more, all channels show that.
/// Black where `comparison` says that pixels count as equal. The pictures are those it was made of, of one size.
Image differencePicture(const Picture& first, const Picture& second, const PictureComparison& comparison);

/// FLIP's errors from black over violet and orange to pale yellow. @param comparison with FLIP, of one size.
Image heatmapPicture(const PictureComparison& comparison);

}  // namespace knuckle
