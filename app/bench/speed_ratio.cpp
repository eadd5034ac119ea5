#include "app/bench/speed_ratio.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace knuckle {

namespace {

/// The probability that fewer than `k` of `n` coins show heads.
double fewerHeads(size_t n, size_t k)
{
    const auto count = static_cast<double>(n);
    double sum = 0.0;
    for (size_t i = 0; i < k; ++i) {
        const auto heads = static_cast<double>(i);
        sum += std::exp(std::lgamma(count + 1) - std::lgamma(heads + 1) - std::lgamma(count - heads + 1) -
                        count * std::log(2.0));
    }
    return sum;
}

double middleRatio(const std::vector<double>& sorted)
{
    const size_t half = sorted.size() / 2;
    // Between two ratios lies their geometric mean: so A beside B gives the inverse of B beside A.
    return sorted.size() % 2 == 1 ? sorted[half] : std::sqrt(sorted[half - 1] * sorted[half]);
}

}  // namespace

SpeedRatio speedRatio(std::span<const double> a, std::span<const double> b)
{
    if (a.empty() || a.size() != b.size()) throw std::logic_error("speedRatio: needs pairs of times");
    std::vector<double> ratios;
    for (size_t i = 0; i < a.size(); ++i) {
        if (!(a[i] > 0.0) || !(b[i] > 0.0)) throw std::logic_error("speedRatio: needs times above zero");
        ratios.push_back(a[i] / b[i]);
    }
    std::ranges::sort(ratios);
    const size_t n = ratios.size();
    size_t k = 1;
    while (2 * (k + 1) <= n && 1.0 - 2.0 * fewerHeads(n, k + 1) >= WANTED_CONFIDENCE) ++k;
    return {middleRatio(ratios), ratios[k - 1], ratios[n - k], 1.0 - 2.0 * fewerHeads(n, k)};
}

}  // namespace knuckle
