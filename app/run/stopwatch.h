#pragma once

#include <chrono>
#include <utility>

namespace knuckle {

/// Adds the time until the end of its scope to `sum` [s].
class Stopwatch {
public:
    explicit Stopwatch(double& sum) : sum_(sum) {}
    ~Stopwatch() { sum_ += std::chrono::duration<double>(Clock::now() - start_).count(); }
    Stopwatch(const Stopwatch&) = delete;
    Stopwatch& operator=(const Stopwatch&) = delete;

private:
    using Clock = std::chrono::steady_clock;
    double& sum_;
    Clock::time_point start_ = Clock::now();
};

/// How long the work takes [s].
template <typename Work>
double secondsOf(Work work)
{
    double seconds = 0.0;
    {
        const Stopwatch watch(seconds);
        work();
    }
    return seconds;
}

/// Tells the time since it was made, or since it last did.
class LapClock {
public:
    /// [s]
    double lap()
    {
        const Clock::time_point last = std::exchange(last_, Clock::now());
        return std::chrono::duration<double>(last_ - last).count();
    }

private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point last_ = Clock::now();
};

}  // namespace knuckle
