#include "render/compare/flip/flip_filters.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace knuckle {

namespace {

constexpr double PI_SQUARED = std::numbers::pi * std::numbers::pi;
/// Parameters of the contrast sensitivity functions (table 1 of the paper): amplitude and width [degrees squared].
constexpr double BRIGHTNESS_WIDTH = 0.0047, RED_GREEN_WIDTH = 0.0053;
constexpr double BLUE_YELLOW_HEIGHT = 34.1, BLUE_YELLOW_WIDTH = 0.04;
constexpr double BLUE_YELLOW_NARROW_HEIGHT = 13.5, BLUE_YELLOW_NARROW_WIDTH = 0.025;
/// Peak to trough of the human edge detector [degrees]: two standard deviations.
constexpr double FEATURE_WIDTH = 0.082;
/// Weights below this share of the middle one are left out: they change no bit that is shown.
constexpr double NEGLIGIBLE = 1e-8;

using Weights = std::vector<double>;

Weights gaussian(int radius, double exponent)
{
    Weights weights;
    for (int x = -radius; x <= radius; ++x) weights.push_back(std::exp(-exponent * x * x));
    return weights;
}

double sumOf(const Weights& weights)
{
    double sum = 0.0;
    for (const double weight : weights) sum += weight;
    return sum;
}

/// Divides by the sum, and leaves out ends that do not count.
std::vector<float> normalized(const Weights& weights)
{
    const double sum = sumOf(weights);
    const size_t middle = weights.size() / 2;
    size_t first = 0;
    while (first < middle && weights[first] < NEGLIGIBLE * weights[middle]) ++first;
    std::vector<float> kernel;
    for (size_t i = first; i + first < weights.size(); ++i) kernel.push_back(static_cast<float>(weights[i] / sum));
    return kernel;
}

/// Divides positive weights by their sum, negative ones by theirs.
std::vector<float> balanced(const Weights& weights)
{
    double positive = 0.0, negative = 0.0;
    for (const double weight : weights) (weight > 0.0 ? positive : negative) += std::fabs(weight);
    std::vector<float> kernel;
    kernel.reserve(weights.size());
    for (const double weight : weights)
        kernel.push_back(static_cast<float>(weight / (weight > 0 ? positive : negative)));
    return kernel;
}

void addFeatureFilters(double pixelsPerDegree, FlipFilters& filters)
{
    const double deviation = 0.5 * FEATURE_WIDTH * pixelsPerDegree;
    const int radius = static_cast<int>(std::ceil(3.0 * deviation));
    const Weights smooth = gaussian(radius, 0.5 / (deviation * deviation));
    Weights edge = smooth, point = smooth;
    for (size_t i = 0; i < smooth.size(); ++i) {
        const double x = static_cast<double>(i) - radius;
        edge[i] *= -x;
        point[i] *= x * x / (deviation * deviation) - 1.0;
    }
    double sum = sumOf(smooth);
    for (const double weight : smooth) filters.smooth.push_back(static_cast<float>(weight / sum));
    filters.edge = balanced(edge);
    filters.point = balanced(point);
    filters.reach = std::max(filters.reach, static_cast<uint32_t>(radius));
}

/// Adds rows times the kernel's weights to a row. Four at a time, so that the sum is not loaded and stored for each.
/// @param step from one row to the next.
void addWeighted(const float* rows, size_t step, const std::vector<float>& kernel, float scale, uint32_t width,
                 float* __restrict to)
{
    size_t k = 0;
    for (; k + 4 <= kernel.size(); k += 4) {
        const float *a = rows + k * step, *b = a + step, *c = b + step, *d = c + step;
        const float u = kernel[k] * scale, v = kernel[k + 1] * scale, w = kernel[k + 2] * scale,
                    z = kernel[k + 3] * scale;
        for (uint32_t x = 0; x < width; ++x) to[x] += (u * a[x] + v * b[x]) + (w * c[x] + z * d[x]);
    }
    for (; k < kernel.size(); ++k) {
        const float* from = rows + k * step;
        const float weight = kernel[k] * scale;
        for (uint32_t x = 0; x < width; ++x) to[x] += weight * from[x];
    }
}

}  // namespace

FlipFilters makeFlipFilters(double pixelsPerDegree)
{
    FlipFilters filters;
    const double widest = std::sqrt(BLUE_YELLOW_WIDTH / (2.0 * PI_SQUARED));
    const int radius = static_cast<int>(std::ceil(3.0 * widest * pixelsPerDegree));
    const auto sensitivity = [&](double width) {
        return gaussian(radius, PI_SQUARED / (width * pixelsPerDegree * pixelsPerDegree));
    };
    filters.brightness = normalized(sensitivity(BRIGHTNESS_WIDTH));
    filters.redGreen = normalized(sensitivity(RED_GREEN_WIDTH));
    const Weights wide = sensitivity(BLUE_YELLOW_WIDTH), narrow = sensitivity(BLUE_YELLOW_NARROW_WIDTH);
    filters.blueYellow = normalized(wide);
    filters.blueYellowNarrow = normalized(narrow);
    // What each of the two adds to the sum over the plane, which is 1.
    const auto share = [](double height, double width, const Weights& weights) {
        return height * std::sqrt(std::numbers::pi / width) * sumOf(weights) * sumOf(weights);
    };
    const double wideShare = share(BLUE_YELLOW_HEIGHT, BLUE_YELLOW_WIDTH, wide);
    const double narrowShare = share(BLUE_YELLOW_NARROW_HEIGHT, BLUE_YELLOW_NARROW_WIDTH, narrow);
    filters.blueYellowWeight = static_cast<float>(wideShare / (wideShare + narrowShare));
    filters.blueYellowNarrowWeight = static_cast<float>(narrowShare / (wideShare + narrowShare));
    filters.reach = static_cast<uint32_t>(radius);
    addFeatureFilters(pixelsPerDegree, filters);
    return filters;
}

void filterRows(const Plane& in, const std::vector<float>& kernel, uint32_t reach, Plane& out)
{
    out.resize(in.width - 2 * reach, in.height);
    const uint32_t first = reach - static_cast<uint32_t>(kernel.size() / 2);
    for (uint32_t y = 0; y < in.height; ++y) {
        float* to = out.row(y);
        std::fill_n(to, out.width, 0.0f);
        addWeighted(in.row(y) + first, 1, kernel, 1.0f, out.width, to);
    }
}

void filterColumns(const Plane& in, const std::vector<float>& kernel, uint32_t reach, float scale, bool add, Plane& out)
{
    out.resize(in.width, in.height - 2 * reach);
    const uint32_t first = reach - static_cast<uint32_t>(kernel.size() / 2);
    for (uint32_t y = 0; y < out.height; ++y) {
        float* to = out.row(y);
        if (!add) std::fill_n(to, out.width, 0.0f);
        addWeighted(in.row(y + first), in.width, kernel, scale, out.width, to);
    }
}

}  // namespace knuckle
