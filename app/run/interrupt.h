#pragma once

namespace knuckle {

/// Thrown when the user asked to stop. Ends the program with exit code 130.
struct Interrupted {};

/// From now on SIGINT, SIGTERM and SIGHUP end the program at once, in any state, with exit code 130: temporary files
/// are removed, and programs that it started are ended.
void endOnSignals();

/// While an object of this class exists, such a signal only sets a flag, so that the frame is finished. A second
/// signal, or GRACE_SECONDS, end the program as usual.
class InterruptGuard {
public:
    static constexpr unsigned GRACE_SECONDS = 5;  ///< A driver may hang; `docker stop` kills after 10.

    InterruptGuard();
    ~InterruptGuard();
    InterruptGuard(const InterruptGuard&) = delete;
    InterruptGuard& operator=(const InterruptGuard&) = delete;

    bool isSignalled() const;
    /// @throws Interrupted after a signal.
    void check() const;
};

}  // namespace knuckle
