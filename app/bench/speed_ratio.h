#pragma once

#include <span>

namespace knuckle {

/// How fast B is beside A: 1.1 is ten percent faster.
struct SpeedRatio {
    double median = 1.0;
    double low = 1.0, high = 1.0;  ///< An interval that holds the true median ...
    double confidence = 0.0;       ///< ... with this probability.

    bool isFaster() const { return low > 1.0; }
    bool isSlower() const { return high < 1.0; }
};

/// What confidence an interval should have at least, and the fewest pairs that give it.
inline constexpr double WANTED_CONFIDENCE = 0.95;
inline constexpr int FEWEST_PAIRS = 6;

/// Of times of A and of B, in pairs measured one after the other, so that a machine that changes its speed changes both
/// of a pair. The interval is from the kth smallest ratio to the kth largest: whether the median of all ratios is below
/// a ratio is a toss of a coin, so k - 1 are at most that far out in 1 - 2 P(Binomial(n, 1/2) < k) of all cases,
/// however times scatter. k is the largest with that above WANTED_CONFIDENCE, or 1.
/// @param a, b times above zero, as many of each, at least one. @throws std::logic_error otherwise.
SpeedRatio speedRatio(std::span<const double> a, std::span<const double> b);

}  // namespace knuckle
