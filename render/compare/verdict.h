#pragma once

#include <optional>
#include <string>
#include <vector>

#include "render/compare/comparison.h"

namespace knuckle {

/// Up to where two pictures count as equal. Each that is not empty must hold.
///
/// The defaults let pass what two drivers make of one scene: roundings of one or two steps of 255, and here and there a
/// pixel of an edge. They find what is small and there: a few pixels that stand alone, a thing of the size of an icon,
/// a picture that has become 3 % brighter.
struct CompareLimits {
    std::optional<uint64_t> pixels;       ///< Changed pixels.
    std::optional<double> share = 0.005;  ///< Changed pixels as a share of the compared ones, 0-1.
    std::optional<double> mean = 1.0;     ///< Mean difference, 0-255.
    std::optional<double> largest;        ///< Largest difference of a channel, 0-255.
    std::optional<double> tile = 1.0;     ///< Score of the worst tile.
    std::optional<double> flip = 0.05;    ///< Mean of FLIP, 0-1.
    std::optional<double> ssim;           ///< At least, -1 to 1.
};

struct Verdict {
    bool equal = true;
    std::vector<std::string> reasons;  ///< Each limit that does not hold, in words with both numbers.

    /// "equal" or "different".
    const char* word() const { return equal ? "equal" : "different"; }
};

/// Pictures of different sizes are different, whatever the limits.
Verdict judge(const PictureComparison& comparison, const CompareLimits& limits);

/// The verdict and its reasons in one line, with the figures that matter.
std::string verdictLine(const PictureComparison& comparison, const Verdict& verdict);
/// "the difference is in 3 places, the largest at 412,230, 60 x 40"; empty where there is none.
std::string placesLine(const PictureComparison& comparison);

/// Four digits that count, so that what is not 0 is not shown as 0.
std::string shortNumber(double value);
/// "at 412,230, 60 x 40".
std::string boxWords(const PixelBox& box);

}  // namespace knuckle
