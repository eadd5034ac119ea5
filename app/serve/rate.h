#pragma once

#include <chrono>
#include <cstdint>

namespace knuckle {

/// How often something happens.
class Rate {
public:
    void note() { ++count_; }
    /// In the last whole second [1/s].
    double now()
    {
        const std::chrono::duration<double> passed = Clock::now() - from_;
        if (passed.count() < 1.0) return rate_;
        rate_ = count_ / passed.count();
        count_ = 0;
        from_ = Clock::now();
        return rate_;
    }

private:
    using Clock = std::chrono::steady_clock;

    uint32_t count_ = 0;
    double rate_ = 0.0;
    Clock::time_point from_ = Clock::now();
};

}  // namespace knuckle
