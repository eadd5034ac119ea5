#include "sim/gpu/device/driver_threads.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstdlib>
#include <mutex>
#include <thread>
#include <vector>

#include "sim/base/cores.h"

namespace knuckle {

namespace {

/// What each further core adds to the speed of one: 60 frames of 1280 x 720 take 8.6 s on one thread, 5.6 s on two.
constexpr double CORE_GAIN = 0.55;
/// Threads that wake each other to draw one frame during the next one's simulation.
constexpr double HANDOVERS = 2.0;
/// How long waking is timed [s].
constexpr double TRIAL = 0.01;
/// Between two dispatches [s].
constexpr double PAUSE = 2e-5;

/// Threads that wait for work like llvmpipe's: under one lock, one signal wakes all, the last one answers.
class Pool {
public:
    explicit Pool(uint32_t size) : size_(size)
    {
        try {
            for (uint32_t i = 0; i < size; ++i) threads_.emplace_back([this] { work(); });
        } catch (...) {
            end();  // the system gives no more threads
            throw;
        }
    }
    ~Pool() { end(); }
    void round()
    {
        std::unique_lock lock(mutex_);
        ++round_;
        left_ = size_;
        start_.notify_all();
        done_.wait(lock, [&] { return left_ == 0; });
    }

private:
    void end()
    {
        {
            const std::lock_guard lock(mutex_);
            ends_ = true;
        }
        start_.notify_all();
        for (std::thread& thread : threads_) thread.join();
    }
    void work()
    {
        uint64_t seen = 0;
        std::unique_lock lock(mutex_);
        for (;;) {
            start_.wait(lock, [&] { return ends_ || round_ != seen; });
            if (ends_) return;
            seen = round_;
            if (--left_ == 0) done_.notify_one();
        }
    }
    const uint32_t size_;
    std::mutex mutex_;
    std::condition_variable start_, done_;
    uint64_t round_ = 0;
    uint32_t left_ = 0;
    bool ends_ = false;
    std::vector<std::thread> threads_;
};

}  // namespace

DriverThreads chooseDriverThreads(const FrameWork& work, uint32_t cores, double wakeMilliseconds,
                                  std::optional<bool> threads)
{
    if (cores < 2) return {0, false, "there is one core"};
    const double speed = 1.0 + CORE_GAIN * (cores - 1);
    const auto time = [&](const Workload& part, bool woken) {
        return woken ? part.milliseconds / speed + part.dispatches * wakeMilliseconds : part.milliseconds;
    };
    const auto inTurn = [&](bool woken) { return time(work.simulation, woken) + time(work.drawing, woken); };
    const auto aside = [&](bool woken) {
        const double longer = std::max(time(work.simulation, woken), time(work.drawing, woken));
        const double all = (work.simulation + work.drawing).milliseconds / speed;
        return std::max(longer, all) + HANDOVERS * wakeMilliseconds;
    };
    const auto best = [&](bool woken) { return std::min(inTurn(woken), aside(woken)); };
    const bool woken = threads.value_or(best(true) < best(false));
    const bool isAside = aside(woken) < inTurn(woken);
    const std::string reason = fmt::format(
        "a frame is estimated to take {:.1f} ms with a driver thread for each of {} cores, {:.1f} ms with none; waking "
        "them takes {:.3f} ms",
        best(true), cores, best(false), wakeMilliseconds);
    return {woken ? cores : 0u, isAside, reason};
}

double wakeTime(uint32_t threads)
{
    using Clock = std::chrono::steady_clock;
    Pool pool(threads);
    pool.round();  // until all have started
    const auto seconds = [](Clock::time_point since) {
        return std::chrono::duration<double>(Clock::now() - since).count();
    };
    const auto first = Clock::now();
    double sum = 0.0;
    int rounds = 0;
    for (; rounds == 0 || seconds(first) < TRIAL; ++rounds) {
        // Meanwhile the host prepares the next dispatch, long enough for the others to fall asleep.
        for (const auto since = Clock::now(); seconds(since) < PAUSE;) continue;
        const auto start = Clock::now();
        pool.round();
        sum += seconds(start);
    }
    return 1000.0 * sum / rounds;
}

std::string driverThreadsSetting()
{
    const char* set = std::getenv(DRIVER_THREADS_VARIABLE);
    return set != nullptr ? set : "";
}

DriverThreads applyDriverThreads(const FrameWork& work)
{
    const uint32_t cores = usableCores();
    const double wake = cores > 1 ? wakeTime(cores) : 0.0;
    const std::string set = driverThreadsSetting();
    if (set.empty()) {
        DriverThreads choice = chooseDriverThreads(work, cores, wake);
        setenv(DRIVER_THREADS_VARIABLE, std::to_string(*choice.count).c_str(), 1);
        return choice;
    }
    DriverThreads choice = chooseDriverThreads(work, cores, wake, set != "0");
    choice.count.reset();
    choice.reason = fmt::format("{} is set to {}", DRIVER_THREADS_VARIABLE, set);
    return choice;
}

}  // namespace knuckle
