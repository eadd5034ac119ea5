#pragma once

#include <string>

namespace knuckle {

/// @throws std::system_error if standard output cannot be written.
void flushStandardOutput();
/// Prints a line to standard error, after everything printed before: both may go to one file.
/// @throws std::system_error if standard output cannot be written.
void tellUser(const std::string& line);

}  // namespace knuckle
