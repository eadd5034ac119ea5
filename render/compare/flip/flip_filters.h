#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace knuckle {

/// FLIP's filters as products of one along rows and one along columns. A kernel has 2 r + 1 weights, its middle one at
/// r.
struct FlipFilters {
    /// Contrast sensitivity: Gaussians with the sum 1 for brightness and for red-green; for blue-yellow two of them,
    /// weighted.
    std::vector<float> brightness, redGreen, blueYellow, blueYellowNarrow;
    float blueYellowWeight = 0.0f, blueYellowNarrowWeight = 0.0f;
    /// Features: a Gaussian with the sum 1 across, its first (edges) and second (points) derivative along, with
    /// positive weights that add up to 1 and negative ones to -1.
    std::vector<float> smooth, edge, point;
    uint32_t reach = 0;  ///< The largest of all r.
};

FlipFilters makeFlipFilters(double pixelsPerDegree);

/// Pixels of one channel, top row first.
struct Plane {
    uint32_t width = 0, height = 0;
    std::vector<float> values;

    void resize(uint32_t newWidth, uint32_t newHeight)
    {
        width = newWidth;
        height = newHeight;
        values.resize(static_cast<size_t>(width) * height);
    }
    float* row(uint32_t y) { return &values[static_cast<size_t>(y) * width]; }
    const float* row(uint32_t y) const { return &values[static_cast<size_t>(y) * width]; }
};

/// Filters along rows: `out` is narrower by `reach` pixels on both sides, and as high.
void filterRows(const Plane& in, const std::vector<float>& kernel, uint32_t reach, Plane& out);
/// Filters along columns: `out` is lower by `reach` pixels on both sides. @param scale of what is stored, or added to
/// it.
void filterColumns(const Plane& in, const std::vector<float>& kernel, uint32_t reach, float scale, bool add,
                   Plane& out);

}  // namespace knuckle
