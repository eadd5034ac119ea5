#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace knuckle {

/// The environment variable by which llvmpipe is told its number of threads.
inline constexpr const char* DRIVER_THREADS_VARIABLE = "LP_NUM_THREADS";

/// What a run asks of a software driver, say for one frame.
struct Workload {
    double dispatches = 0.0;    ///< Filters, each of which wakes the driver's threads and waits for them.
    double milliseconds = 0.0;  ///< What they compute, on one thread.

    Workload operator+(const Workload& other) const
    {
        return {dispatches + other.dispatches, milliseconds + other.milliseconds};
    }
    Workload operator*(double factor) const { return {dispatches * factor, milliseconds * factor}; }
};

/// A frame's.
struct FrameWork {
    Workload simulation, drawing;
};

/// How many threads llvmpipe computes with besides the caller's, whether a frame is drawn on another thread of the
/// program while the next is simulated, and why.
struct DriverThreads {
    std::optional<uint32_t> count;  ///< None: the program has not chosen.
    bool drawAside = false;
    std::string reason;  ///< A clause for the user.
};

/// The fastest of four ways to make frames: the driver has a thread for each core, or none and works in the caller's
/// thread; a frame is drawn after it is simulated, or on a second thread while the next one is simulated.
/// @param cores that the process may use. @param wakeMilliseconds of all of them, for one dispatch (wakeTime).
/// @param threads of the driver, where they are not to be chosen.
DriverThreads chooseDriverThreads(const FrameWork& work, uint32_t cores, double wakeMilliseconds,
                                  std::optional<bool> threads = {});

/// How long it takes to wake `threads` threads that wait for work, and to hear from the last of them [ms]: the mean
/// over ten milliseconds, since on a busy machine a few take as long as all others together.
double wakeTime(uint32_t threads);

/// Cores that this process may run on, at least 1.
uint32_t usableCores();

/// What the variable is set to, empty for nothing.
std::string driverThreadsSetting();

/// Chooses, and tells llvmpipe: before the first context of the process, since it looks once. Leaves a
/// variable that is set already.
DriverThreads applyDriverThreads(const FrameWork& work);

}  // namespace knuckle
