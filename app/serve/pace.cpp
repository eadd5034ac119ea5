#include "app/serve/pace.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace knuckle {

void Pace::clear()
{
    asked_ = 0;
    owed_ = 0.0;
}

void Pace::begin(double timeStep)
{
    clear();
    timeStep_ = timeStep;
    stepSeconds_ = 0.0;
}

uint32_t Pace::due()
{
    constexpr uint32_t MOST = 64;
    const Clock::time_point now = Clock::now();
    const std::chrono::duration<double> passed = now - std::exchange(looked_, now);
    const uint32_t fitting = stepSeconds_ > 0.0
                                 ? static_cast<uint32_t>(std::clamp(BATCH / stepSeconds_, 1.0, double(MOST)))
                                 : 1;
    if (asked_ > 0) {
        const uint32_t steps = std::min(asked_, fitting);
        asked_ -= steps;
        return steps;
    }
    if (paused_) {
        owed_ = 0.0;
        return 0;
    }
    owed_ = std::min(owed_ + speed_ * passed.count(), std::max(timeStep_, 2.0 * BATCH));
    const uint32_t steps = std::min(static_cast<uint32_t>(owed_ / timeStep_), fitting);
    owed_ -= steps * timeStep_;
    return steps;
}

std::chrono::microseconds Pace::untilNext() const
{
    if (asked_ > 0) return {};
    if (paused_) return std::chrono::seconds(1);
    return std::chrono::microseconds(static_cast<int64_t>(1e6 * std::max(0.0, timeStep_ - owed_) / speed_));
}

void Pace::took(uint32_t steps, double seconds)
{
    if (steps == 0) return;
    const double each = seconds / steps;
    stepSeconds_ = stepSeconds_ > 0.0 ? 0.8 * stepSeconds_ + 0.2 * each : each;
}

}  // namespace knuckle
