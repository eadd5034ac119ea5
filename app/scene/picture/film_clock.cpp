#include "app/scene/picture/film_clock.h"

#include <algorithm>
#include <cmath>

namespace knuckle {

FilmClock::FilmClock(double framesPerSecond, uint32_t stepsPerFrame, const std::vector<Shot>& shots)
    : paces_{Pace{.perFrame = static_cast<double>(stepsPerFrame)}}
{
    constexpr double ROUNDING = 1e-6;  // as in shotAt(), [s]
    for (const Shot& shot : shots) {
        const double index = std::ceil((shot.from - ROUNDING) * framesPerSecond);
        const uint64_t first = 1 + static_cast<uint64_t>(std::max(index, 0.0));
        const double perFrame = static_cast<double>(shot.timeScale) * stepsPerFrame;
        even_ = even_ && shot.timeScale == 1.0f;
        const Pace& last = paces_.back();
        if (perFrame == last.perFrame) continue;
        const Pace next{first, last.steps + static_cast<double>(first - last.frame) * last.perFrame, perFrame};
        if (first == last.frame) paces_.back() = next;
        else paces_.push_back(next);
    }
}

FramePlace FilmClock::at(uint64_t frame) const
{
    constexpr double ROUNDING = 1e-6;  // of a step
    size_t k = paces_.size() - 1;
    while (k > 0 && paces_[k].frame > frame) --k;
    const double steps = paces_[k].steps + static_cast<double>(frame - paces_[k].frame) * paces_[k].perFrame;
    const double whole = std::ceil(steps - ROUNDING), part = 1.0 - (whole - steps);
    return {static_cast<uint64_t>(std::max(whole, 0.0)), part > 1.0 - ROUNDING ? 1.0 : part};
}

}  // namespace knuckle
