#pragma once

namespace knuckle {

/// Exit codes of the program.
enum ExitCode {
    EXIT_FINE = 0,
    EXIT_RUN = 1,
    EXIT_INPUT = 2,
    EXIT_DEVICE = 3,
    EXIT_DIFFERENT = 4,
    EXIT_INTERRUPTED = 130,
};

}  // namespace knuckle
