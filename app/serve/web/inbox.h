#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <vector>

#include "app/serve/web/input.h"

namespace knuckle {

/// Wishes of viewers on their way to the thread that simulates.
class Inbox {
public:
    static constexpr size_t MOST_WAITING = 256;
    static constexpr double MOST_A_SECOND = 200.0;  ///< As many at once, too.

    /// @returns false, and takes nothing, if there were too many of late, or too many wait.
    bool put(const Input& input);
    /// All that came since the last call.
    std::vector<Input> take();
    /// Returns after that time, or as soon as there is something to take or wake() is called.
    void wait(std::chrono::microseconds longest);
    void wake();

private:
    using Clock = std::chrono::steady_clock;

    std::mutex mutex_;
    std::condition_variable changed_;
    std::vector<Input> inputs_;
    double allowed_ = MOST_A_SECOND;
    Clock::time_point counted_ = Clock::now();
    bool woken_ = false;
};

}  // namespace knuckle
