#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>

namespace knuckle {

/// How many steps are due, so that simulated time passes as fast as time does, or slower; never faster.
class Pace {
public:
    using Clock = std::chrono::steady_clock;

    /// @param timeStep [s]
    explicit Pace(double timeStep) : timeStep_(timeStep) {}

    /// Simulated seconds a second.
    void setSpeed(double speed) { speed_ = speed; }
    double speed() const { return speed_; }
    void pause(bool paused) { paused_ = paused; }
    bool isPaused() const { return paused_; }
    /// So many steps, paused or not.
    void ask(uint32_t steps) { asked_ += steps; }
    /// Forgets what was asked for, as before a start.
    void clear();
    /// The same, and how long steps took: another simulation begins. @param timeStep [s]
    void begin(double timeStep);
    /// Whether steps that were due could not be taken in time.
    bool isBehind() const { return owed_ > std::max(BATCH, 2.0 * timeStep_); }

    /// Steps to take now, at most as many as a machine takes in BATCH; what it cannot keep up with is forgotten.
    uint32_t due();
    /// Until the next is due.
    std::chrono::microseconds untilNext() const;
    /// @param seconds that the steps took.
    void took(uint32_t steps, double seconds);
    /// Mean of late [s].
    double stepSeconds() const { return stepSeconds_; }

private:
    static constexpr double BATCH = 0.04;  // [s]

    double timeStep_, speed_ = 1.0, owed_ = 0.0, stepSeconds_ = 0.0;
    uint32_t asked_ = 0;
    bool paused_ = false;
    Clock::time_point looked_ = Clock::now();
};

}  // namespace knuckle
