#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "render/reader/picture.h"

namespace knuckle {

/// Pixels per degree of sight on a 0.7 m wide screen of 3840 pixels seen from 0.7 m, FLIP's default.
constexpr double DEFAULT_PIXELS_PER_DEGREE = 67.0206432766;

struct FlipSettings {
    double pixelsPerDegree = DEFAULT_PIXELS_PER_DEGREE;  ///< 1 to 1000.
    std::array<float, 3> background = {};                ///< On which pictures with alpha are seen, sRGB-encoded.
};

struct FlipResult {
    double mean = 0.0, max = 0.0;  ///< 0-1; the mean is over the compared pixels.
    std::vector<float> errors;     ///< Of each pixel, 0-1; empty where all are 0.
};

/// FLIP, how much a person who flips between two pictures sees them differ: Andersson et al., "FLIP: A Difference
/// Evaluator for Alternating Images" (2020). If both are `hdr`, it is the worst of the errors at the exposures of
/// "Visualizing Errors in Rendered High Dynamic Range Images" (2021), by the ACES tone mapper; else values are cut off
/// at 0 and 1. `a` is the reference: HDR exposures are chosen by it; else both may be swapped.
///
/// @param marks width * height, not 0 where the pictures may differ. Elsewhere they are equal, and where no mark is
/// near, the error is 0 and costs nothing. @param compared pixels, over which the mean is taken.
FlipResult flip(const Picture& a, const Picture& b, const std::vector<uint8_t>& marks, const FlipSettings& settings,
                uint64_t compared, unsigned threads);

/// First and last exposure [stops] and how many there are between, both included, for HDR-FLIP.
struct Exposures {
    float start = 0.0f, stop = 0.0f;
    uint32_t count = 1;
};

/// By the reference's brightest and its median luminance; a median of 0 is taken over what is not black. At most 64.
Exposures exposuresOf(const Picture& reference);

/// The ACES tone mapper that HDR-FLIP takes. @param light linear, exposed. @returns linear, 0 to 1.
float toneMapAces(float light);

}  // namespace knuckle
