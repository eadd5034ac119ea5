#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace knuckle {

/// Prints frames done, rate and time left to stderr: one rewritten line on a terminal, elsewhere a line every ten
/// seconds.
class Progress {
public:
    Progress(std::string what, uint64_t total, bool quiet);
    /// Ends a rewritten line.
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// Some were done before the start: they say nothing of the rate.
    void begin(uint64_t done) { first_ = done; }
    void update(uint64_t done);
    /// Since the start [s].
    double seconds() const;

private:
    using Clock = std::chrono::steady_clock;
    std::string what_;
    uint64_t total_;
    bool shown_, terminal_, dirty_ = false;
    Clock::time_point start_ = Clock::now(), last_ = start_, rateStart_ = start_;
    uint64_t first_ = 0, rateDone_ = 0;  ///< Done at the start, and at rateStart_.
};

/// "12 s", "3 min 05 s", "2 h 10 min".
std::string durationText(double seconds);

}  // namespace knuckle
