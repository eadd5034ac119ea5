#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace knuckle {

/// The environment variable for llvmpipe's number of threads.
inline constexpr const char* DRIVER_THREADS_VARIABLE = "LP_NUM_THREADS";

/// Work of a run for a software driver, for example for one frame.
struct Workload {
    double dispatches = 0.0;    ///< Filters, each of which wakes the driver's threads and waits for them.
    double milliseconds = 0.0;  ///< Time to compute them on one thread.

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

/// Number of llvmpipe's threads besides the caller's, whether a frame is drawn on another thread of the program during
/// the next one's simulation, and the reason.
struct DriverThreads {
    std::optional<uint32_t> count;  ///< None: the program has not chosen.
    bool drawAside = false;
    std::string reason;  ///< A clause for the user.
};

/// The fastest of four ways to make frames: the driver has a thread for each core, or none and works in the caller's
/// thread; a frame is drawn after its simulation, or on a second thread during the next one's simulation.
/// @param cores that the process may use. @param wakeMilliseconds for one dispatch to wake all of them (wakeTime).
/// @param threads of the driver, if they are given.
DriverThreads chooseDriverThreads(const FrameWork& work, uint32_t cores, double wakeMilliseconds,
                                  std::optional<bool> threads = {});

/// The time to wake `threads` waiting threads and to hear from the last of them [ms]: the mean over ten milliseconds,
/// since on a busy machine a few wakes take as long as all others together.
double wakeTime(uint32_t threads);

/// The variable's value, empty if not set.
std::string driverThreadsSetting();

/// Chooses threads and tells llvmpipe: before the first context of the process, since llvmpipe looks only once. Does
/// not change a variable that is set already.
DriverThreads applyDriverThreads(const FrameWork& work);

}  // namespace knuckle
