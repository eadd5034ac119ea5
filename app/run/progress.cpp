#include "app/run/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "app/run/tell.h"

namespace knuckle {

namespace {

using namespace std::chrono_literals;

/// Frames during which shaders are compiled; their times do not predict later ones.
constexpr uint64_t WARM_UP = 2;
constexpr std::chrono::milliseconds TERMINAL_INTERVAL = 200ms, PLAIN_INTERVAL = 10s;

double secondsOf(std::chrono::steady_clock::duration duration)
{
    return std::chrono::duration<double>(duration).count();
}

}  // namespace

Progress::Progress(std::string what, uint64_t total, bool quiet)
    : what_(std::move(what)), total_(total), shown_(!quiet), terminal_(isatty(fileno(stderr)) == 1)
{
}

Progress::~Progress()
{
    if (dirty_) std::fputc('\n', stderr);
}

double Progress::seconds() const
{
    return secondsOf(Clock::now() - start_);
}

void Progress::update(uint64_t done)
{
    const auto now = Clock::now();
    if (done <= first_ + WARM_UP) {
        rateStart_ = now;
        rateDone_ = done;
    }
    const bool due = now - last_ >= (terminal_ ? TERMINAL_INTERVAL : PLAIN_INTERVAL);
    if (!shown_ || (!due && !(terminal_ && done == total_))) return;
    last_ = now;
    std::string line = fmt::format("{} {} of {}", what_, done, total_);
    if (done > rateDone_) {
        const double rate = static_cast<double>(done - rateDone_) / std::max(1e-9, secondsOf(now - rateStart_));
        const double left = static_cast<double>(total_ - done) / rate;
        line += fmt::format(", {:.1f} {}s/s, {} left", rate, what_, durationText(left));
    }
    flushStandardOutput();
    if (terminal_) {
        fmt::print(stderr, "\r\033[K{}", line);
        dirty_ = true;
    } else {
        fmt::print(stderr, "{}\n", line);
    }
    std::fflush(stderr);
}

std::string durationText(double seconds)
{
    const auto whole = static_cast<uint64_t>(std::llround(std::min(seconds, 1e9)));
    if (whole < 60) return fmt::format("{} s", whole);
    if (whole < 3600) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
    return fmt::format("{} h {:02} min", whole / 3600, whole / 60 % 60);
}

}  // namespace knuckle
