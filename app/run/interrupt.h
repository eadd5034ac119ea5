#pragma once

namespace knuckle {

/// Thrown when the user asked to stop. Ends the program with exit code 130.
struct Interrupted {};

/// While an object of this class exists, SIGINT and SIGTERM only set a flag, so that the frame is finished and
/// temporary files are removed. A second signal ends the program at once.
class InterruptGuard {
public:
    InterruptGuard();
    ~InterruptGuard();
    InterruptGuard(const InterruptGuard&) = delete;
    InterruptGuard& operator=(const InterruptGuard&) = delete;

    /// @throws Interrupted after a signal.
    void check() const;
};

}  // namespace knuckle
