#pragma once

#include <string>

namespace knuckle {

/// @throws std::system_error where it cannot be written.
void flushStandardOutput();
/// A line on standard error, after all that was printed before: both may go to one file.
/// @throws std::system_error where standard output cannot be written.
void tellUser(const std::string& line);

}  // namespace knuckle
