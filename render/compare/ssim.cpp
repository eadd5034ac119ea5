#include "render/compare/ssim.h"

#include <algorithm>
#include <cmath>

#include "render/compare/parallel.h"

namespace knuckle {

namespace {

constexpr uint32_t WINDOW = 11;
constexpr double DEVIATION = 1.5;
constexpr double C1 = 0.01 * 0.01, C2 = 0.03 * 0.03;
/// Rows of windows that a thread takes at a time.
constexpr uint32_t BAND = 40;

std::vector<double> windowWeights(uint32_t size)
{
    std::vector<double> weights;
    double sum = 0.0;
    for (uint32_t i = 0; i < size; ++i) {
        const double distance = i - 0.5 * (size - 1);
        weights.push_back(std::exp(-0.5 * distance * distance / (DEVIATION * DEVIATION)));
        sum += weights.back();
    }
    for (double& weight : weights) weight /= sum;
    return weights;
}

double lumaOf(const float* pixel, const std::array<float, 3>& background)
{
    std::array<double, 3> shown{};
    for (size_t c = 0; c < 3; ++c) {
        const float value = pixel[c] + (1.0f - pixel[3]) * background[c];
        // In this order what is no number counts as 0.
        shown[c] = static_cast<double>(std::min(1.0f, std::max(0.0f, value)));
    }
    return 0.299 * shown[0] + 0.587 * shown[1] + 0.114 * shown[2];
}

double similarity(const std::array<double, 5>& means)
{
    const auto [a, b, aa, bb, ab] = means;
    const double varianceA = aa - a * a, varianceB = bb - b * b, covariance = ab - a * b;
    return (2.0 * a * b + C1) * (2.0 * covariance + C2) / ((a * a + b * b + C1) * (varianceA + varianceB + C2));
}

struct BandResult {
    double lost = 0.0, worst = 1.0;  ///< Sum of 1 - similarity.
    uint32_t x = 0, y = 0;
};

class SsimRun {
public:
    SsimRun(const Picture& a, const Picture& b, const std::vector<uint8_t>& marks,
            const std::array<float, 3>& background)
        : a_(a), b_(b), marks_(marks), background_(background), across_(windowWeights(std::min(WINDOW, a.width))),
          down_(windowWeights(std::min(WINDOW, a.height))),
          columns_(a.width - static_cast<uint32_t>(across_.size()) + 1),
          rows_(a.height - static_cast<uint32_t>(down_.size()) + 1)
    {
    }

    SsimResult run(unsigned threads) const
    {
        std::vector<BandResult> bands((rows_ + BAND - 1) / BAND);
        forEachParallel(bands.size(), threads, [&](size_t i) {
            const auto first = static_cast<uint32_t>(i) * BAND;
            bands[i] = bandOf(first, std::min(first + BAND, rows_));
        });
        SsimResult result;
        double lost = 0.0;
        for (const BandResult& band : bands) {
            lost += band.lost;
            if (band.worst >= result.worst) continue;
            result.worst = band.worst;
            result.box = {band.x, band.y, static_cast<uint32_t>(across_.size()), static_cast<uint32_t>(down_.size())};
        }
        result.mean = 1.0 - lost / (static_cast<double>(columns_) * rows_);
        return result;
    }

private:
    using Means = std::array<std::vector<double>, 5>;

    /// Adds rows times weights to a row. @param step from one row to the next.
    static void addWeighted(const double* rows, size_t step, const std::vector<double>& weights, uint32_t width,
                            double* __restrict to)
    {
        size_t k = 0;
        for (; k + 2 <= weights.size(); k += 2) {
            const double *a = rows + k * step, *b = a + step;
            for (uint32_t x = 0; x < width; ++x) to[x] += weights[k] * a[x] + weights[k + 1] * b[x];
        }
        for (; k < weights.size(); ++k)
            for (uint32_t x = 0; x < width; ++x) to[x] += weights[k] * rows[k * step + x];
    }

    /// Weighted means along a row of a, b, a a, b b and a b, for each window's place, into row i of `means`.
    void meansOfRow(uint32_t y, uint32_t i, Means& means) const
    {
        Means values;
        for (std::vector<double>& value : values) value.resize(a_.width);
        for (uint32_t x = 0; x < a_.width; ++x) {
            const size_t at = (static_cast<size_t>(y) * a_.width + x) * 4;
            const double a = lumaOf(&a_.rgba[at], background_), b = lumaOf(&b_.rgba[at], background_);
            values[0][x] = a;
            values[1][x] = b;
            values[2][x] = a * a;
            values[3][x] = b * b;
            values[4][x] = a * b;
        }
        for (size_t m = 0; m < means.size(); ++m)
            addWeighted(values[m].data(), 1, across_, columns_, &means[m][static_cast<size_t>(i) * columns_]);
    }

    bool isMarked(uint32_t first, uint32_t last) const
    {
        const auto begin = marks_.begin() + static_cast<ptrdiff_t>(static_cast<size_t>(first) * a_.width);
        const auto end = marks_.begin() + static_cast<ptrdiff_t>(static_cast<size_t>(last) * a_.width);
        return std::any_of(begin, end, [](uint8_t mark) { return mark != 0; });
    }

    BandResult bandOf(uint32_t first, uint32_t last) const
    {
        BandResult band;
        const auto height = static_cast<uint32_t>(down_.size());
        if (!isMarked(first, last + height - 1)) return band;
        const uint32_t rows = last - first + height - 1;
        Means means, sums;
        for (std::vector<double>& mean : means) mean.resize(static_cast<size_t>(rows) * columns_);
        for (uint32_t i = 0; i < rows; ++i) meansOfRow(first + i, i, means);
        for (uint32_t y = first; y < last; ++y) {
            for (size_t m = 0; m < sums.size(); ++m) {
                sums[m].assign(columns_, 0.0);
                addWeighted(&means[m][static_cast<size_t>(y - first) * columns_], columns_, down_, columns_,
                            sums[m].data());
            }
            for (uint32_t x = 0; x < columns_; ++x) {
                const double value = similarity({sums[0][x], sums[1][x], sums[2][x], sums[3][x], sums[4][x]});
                band.lost += 1.0 - value;
                if (value < band.worst - 1e-12) {
                    band.worst = value;
                    band.x = x;
                    band.y = y;
                }
            }
        }
        return band;
    }

    const Picture &a_, &b_;
    const std::vector<uint8_t>& marks_;
    const std::array<float, 3>& background_;
    std::vector<double> across_, down_;
    uint32_t columns_, rows_;
};

}  // namespace

SsimResult ssim(const Picture& a, const Picture& b, const std::vector<uint8_t>& marks,
                const std::array<float, 3>& background, unsigned threads)
{
    if (std::ranges::none_of(marks, [](uint8_t mark) { return mark != 0; })) return {};
    return SsimRun(a, b, marks, background).run(threads);
}

}  // namespace knuckle
