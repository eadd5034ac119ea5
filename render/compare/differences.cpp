#include "render/compare/differences.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "render/compare/parallel.h"

namespace knuckle {

namespace {

/// Whether 8-bit steps are more than a whole number must not hang on the last bit of a float.
constexpr float TOLERANCE = 1e-3f;

float channelDifference(float a, float b)
{
    if (a == b || (std::isnan(a) && std::isnan(b))) return 0.0f;
    const float difference = std::fabs(a - b) * STEPS;
    return std::isfinite(difference) ? difference : std::numeric_limits<float>::max();
}

/// Sums of a row, added up in the order of the rows.
struct RowSums {
    std::array<double, 4> sums = {};
    std::array<float, 4> largest = {};
    uint64_t differing = 0, changed = 0;
};

RowSums sumsOfRow(const float* a, const float* b, uint32_t width, float threshold, uint8_t* marks)
{
    RowSums row;
    for (uint32_t x = 0; x < width; ++x, a += 4, b += 4) {
        if (a[0] == b[0] && a[1] == b[1] && a[2] == b[2] && a[3] == b[3]) continue;
        float worst = 0.0f;
        for (size_t c = 0; c < 4; ++c) {
            const float difference = channelDifference(a[c], b[c]);
            row.sums[c] += static_cast<double>(difference);
            row.largest[c] = std::max(row.largest[c], difference);
            worst = std::max(worst, difference);
        }
        if (worst <= 0.0f) continue;
        const bool changed = worst > threshold;
        ++row.differing;
        row.changed += changed ? 1 : 0;
        marks[x] = changed ? 2 : 1;
    }
    return row;
}

}  // namespace

float pixelDifference(const float* a, const float* b)
{
    float worst = 0.0f;
    for (size_t c = 0; c < 4; ++c) worst = std::max(worst, channelDifference(a[c], b[c]));
    return worst;
}

Differences findDifferences(const Picture& a, const Picture& b, float threshold, uint64_t compared, unsigned threads)
{
    Differences result;
    result.marks.resize(a.pixelCount());
    std::vector<RowSums> rows(a.height);
    if (threshold > 0.0f) threshold += TOLERANCE;
    forEachParallel(a.height, threads, [&](size_t y) {
        const size_t first = y * a.width;
        rows[y] = sumsOfRow(&a.rgba[first * 4], &b.rgba[first * 4], a.width, threshold, &result.marks[first]);
    });
    for (const RowSums& row : rows) {
        result.differing += row.differing;
        result.changed += row.changed;
        for (size_t c = 0; c < 4; ++c) {
            result.channels[c].mean += row.sums[c];
            result.channels[c].max = std::max(result.channels[c].max, static_cast<double>(row.largest[c]));
        }
    }
    const size_t channels = a.hasAlpha || b.hasAlpha ? 4 : 3;
    for (size_t c = 0; c < 4; ++c) {
        result.channels[c].mean /= static_cast<double>(std::max<uint64_t>(1, compared));
        if (c < channels) result.mean += result.channels[c].mean / static_cast<double>(channels);
        result.max = std::max(result.max, result.channels[c].max);
    }
    return result;
}

}  // namespace knuckle
