#pragma once

#include <cmath>

namespace knuckle {

/// Linear light of a channel of pictures and colour pickers (IEC 61966-2-1). @param srgb 0 to 1.
template <typename Real>
Real linearOfSrgb(Real srgb)
{
    return srgb <= Real(0.04045) ? srgb / Real(12.92) : std::pow((srgb + Real(0.055)) / Real(1.055), Real(2.4));
}

}  // namespace knuckle
