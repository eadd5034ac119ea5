#include "app/bench/speed_ratio.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>
#include <vector>

#include "app/bench/bench_compare.h"

namespace knuckle {
namespace {

/// A's times where B takes one.
SpeedRatio ratioOf(const std::vector<double>& ratios)
{
    return speedRatio(ratios, std::vector<double>(ratios.size(), 1.0));
}

// 1 - 2 (1 + 9) / 2^9, 1 - 2 / 2^6 and 1 - 2 (1 + 20 + ... + C(20, 5)) / 2^20.
TEST(SpeedRatio, IsTheMedianBetweenTwoOfTheRatios)
{
    const SpeedRatio nine = ratioOf({1.05, 1.01, 1.08, 1.02, 0.90, 1.03, 1.04, 1.90, 1.06});
    EXPECT_DOUBLE_EQ(nine.median, 1.04);
    EXPECT_DOUBLE_EQ(nine.low, 1.01);
    EXPECT_DOUBLE_EQ(nine.high, 1.08);
    EXPECT_NEAR(nine.confidence, 0.9609375, 1e-12);
    EXPECT_TRUE(nine.isFaster());
    const SpeedRatio six = ratioOf({1.0, 2.0, 4.0, 1.5, 3.0, 2.5});
    EXPECT_DOUBLE_EQ(six.median, std::sqrt(2.0 * 2.5));
    EXPECT_DOUBLE_EQ(six.low, 1.0);
    EXPECT_DOUBLE_EQ(six.high, 4.0);
    EXPECT_NEAR(six.confidence, 0.96875, 1e-12);
    EXPECT_FALSE(six.isFaster() || six.isSlower());
    std::vector<double> twenty;
    for (int k = 20; k > 0; --k) twenty.push_back(k);
    EXPECT_DOUBLE_EQ(ratioOf(twenty).low, 6.0);
    EXPECT_DOUBLE_EQ(ratioOf(twenty).high, 15.0);
    EXPECT_NEAR(ratioOf(twenty).confidence, 1.0 - 2.0 * 21700.0 / 1048576.0, 1e-12);
}

TEST(SpeedRatio, OfAllPairsOfTimes)
{
    const std::vector<double> a = {2.0, 3.0, 8.0, 4.0, 5.0, 9.0}, b = {4.0, 5.0, 9.0, 8.0, 9.0, 10.0};
    const SpeedRatio there = speedRatio(a, b), back = speedRatio(b, a);
    EXPECT_TRUE(there.isSlower());
    EXPECT_TRUE(back.isFaster());
    EXPECT_NEAR(there.median * back.median, 1.0, 1e-12);
    EXPECT_NEAR(there.low * back.high, 1.0, 1e-12);
    EXPECT_THROW(speedRatio(a, std::vector<double>{1.0}), std::logic_error);
    EXPECT_THROW(ratioOf({1.0, 0.0}), std::logic_error);
    EXPECT_THROW(ratioOf({}), std::logic_error);
    EXPECT_LT(ratioOf(std::vector<double>(FEWEST_PAIRS - 1, 1.0)).confidence, WANTED_CONFIDENCE);
}

// Times that scatter by a factor, some of them by much. Of 4000 intervals with 0.961 each, the share of those that hold
// the true ratio scatters by 0.003.
TEST(SpeedRatio, TheIntervalHoldsTheTruthAsOftenAsItSays)
{
    std::mt19937 random(7);
    const auto uniform = [&] { return (static_cast<double>(random()) + 0.5) / 4294967296.0; };
    constexpr int TRIES = 4000, PAIRS = 9;
    constexpr double TRUTH = 1.1;
    int held = 0;
    for (int k = 0; k < TRIES; ++k) {
        std::vector<double> ratios;
        for (int i = 0; i < PAIRS; ++i) {
            const double cauchy = std::tan(3.141592653589793 * (uniform() - 0.5));
            ratios.push_back(TRUTH * std::exp(std::clamp(0.02 * cauchy, -9.0, 9.0)));
        }
        const SpeedRatio ratio = ratioOf(ratios);
        held += ratio.low <= TRUTH && TRUTH <= ratio.high ? 1 : 0;
    }
    EXPECT_NEAR(static_cast<double>(held) / TRIES, 0.9609375, 0.012);
}

TEST(SpeedRatio, IsToldInWords)
{
    EXPECT_EQ(verdictOf({1.039, 1.012, 1.063, 0.961}), "B is 3.9 % faster (96 %: 1.2 .. 6.3)");
    EXPECT_EQ(verdictOf({0.9, 0.85, 0.95, 0.961}), "B is 10.0 % slower (96 %: 5.0 .. 15.0)");
    EXPECT_EQ(verdictOf({1.01, 0.98, 1.03, 0.961}), "no difference seen (96 %: -2.0 .. 3.0 % faster)");
}

}  // namespace
}  // namespace knuckle
