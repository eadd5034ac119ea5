#pragma once

#include <stdexcept>
#include <string>

namespace knuckle {

/// Code that calls a function against its contract gets std::logic_error; these three are for all other errors.

/// Something the user gave is wrong (scene, model, image, option). The message is one line that says what, where
/// (file, JSON path) and the remedy. Ends the program with exit code 2.
struct InputError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// No usable OpenGL 4.3. The message says what is wrong. Exit code 3.
struct DeviceError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// A run that started well could not go on (disk full, particles turned NaN, out of memory). Exit code 1.
struct RunError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

}  // namespace knuckle
