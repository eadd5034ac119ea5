#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "render/compare/differences.h"

namespace knuckle {

struct SsimResult {
    double mean = 1.0;  ///< Over all windows that lie in the picture; 1: equal.
    double worst = 1.0;
    PixelBox box;  ///< The worst window, the first of equal ones; empty where all are equal.
};

/// Structural similarity (Wang et al. 2004) of luma: windows of 11 x 11 pixels with Gaussian weights of 1.5 pixels, K1
/// = 0.01, K2 = 0.03. Smaller pictures have windows as large as they are. HDR is cut off at 0 and 1.
/// @param marks as for flip(). @param background as well.
SsimResult ssim(const Picture& a, const Picture& b, const std::vector<uint8_t>& marks,
                const std::array<float, 3>& background, unsigned threads);

}  // namespace knuckle
