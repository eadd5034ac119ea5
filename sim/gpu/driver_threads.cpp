#include "sim/gpu/driver_threads.h"

#include <fmt/format.h>
#include <sched.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstdlib>
#include <mutex>
#include <thread>
#include <vector>

namespace knuckle {

namespace {

/// What each further core adds to the speed of one: 60 frames of 1280 x 720 take 8.6 s on one thread, 5.6 s on two.
constexpr double CORE_GAIN = 0.55;
/// Threads that wake each other to draw one frame beside the next one's simulation.
constexpr double HANDOVERS = 2.0;
/// For how long waking is timed [s].
constexpr double TRIAL = 0.01;
/// Between two dispatches [s].
constexpr double PAUSE = 2e-5;

/// Threads that wait for work in the way of llvmpipe's: under one lock, one signal wakes all, the last one answers.
class Pool {
public:
    explicit Pool(uint32_t size) : size_(size)
    {
        for (uint32_t i = 0; i < size; ++i) threads_.emplace_back([this] { work(); });
    }
    ~Pool()
    {
        {
            const std::lock_guard lock(mutex_);
            ends_ = true;
        }
        start_.notify_all();
        for (std::thread& thread : threads_) thread.join();
    }
    void round()
    {
        std::unique_lock lock(mutex_);
        ++round_;
        left_ = size_;
        start_.notify_all();
        done_.wait(lock, [&] { return left_ == 0; });
    }

private:
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

DriverThreads chooseDriverThreads(const Workload& work, uint32_t cores, double wakeMilliseconds)
{
    if (cores < 2) return {0, false, "there is one core"};
    const double speed = 1.0 + CORE_GAIN * (cores - 1);
    const double gain = work.milliseconds * (1.0 - 1.0 / speed), cost = work.dispatches * wakeMilliseconds;
    const std::string reason = fmt::format(
        "{} would save some {:.1f} ms a frame, and waking them costs {:.1f} ms ({:.0f} times {:.3f} ms)", cores, gain,
        cost, work.dispatches, wakeMilliseconds);
    return {gain > cost ? cores : 0u, false, reason};
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
        // The host prepares the next dispatch meanwhile, long enough for the others to fall asleep.
        for (const auto since = Clock::now(); seconds(since) < PAUSE;) continue;
        const auto start = Clock::now();
        pool.round();
        sum += seconds(start);
    }
    return 1000.0 * sum / rounds;
}

uint32_t usableCores()
{
    cpu_set_t set;
    if (sched_getaffinity(0, sizeof(set), &set) == 0) return static_cast<uint32_t>(CPU_COUNT(&set));
    return std::max(1u, std::thread::hardware_concurrency());
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
    DriverThreads choice = set.empty()
                               ? chooseDriverThreads(work.simulation + work.drawing, cores, wake)
                               : DriverThreads{{}, false, fmt::format("{} is set to {}", DRIVER_THREADS_VARIABLE, set)};
    if (choice.count) setenv(DRIVER_THREADS_VARIABLE, std::to_string(*choice.count).c_str(), 1);
    // At best the shorter of both is saved, and a frame is handed over and waited for.
    const double overlap = std::min(work.simulation.milliseconds, work.drawing.milliseconds);
    choice.drawAside = cores > 1 && overlap > HANDOVERS * wake;
    if (choice.drawAside)
        choice.reason += fmt::format("; drawing while the next frame is simulated saves up to {:.1f} ms", overlap);
    return choice;
}

}  // namespace knuckle
