#pragma once

#include <sys/types.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "sim/base/files/leftovers.h"

namespace knuckle {

/// The path of a program in PATH, empty if it is not there.
std::string findProgram(const std::string& name);

/// A running ffmpeg that reads its standard input from us. Killed if destroyed before finish().
class Ffmpeg {
public:
    /// @param arguments without the program's own name. @param output a descriptor for its standard output, -1: none.
    /// @param purpose names the film in messages. @throws RunError when it cannot be started.
    Ffmpeg(const std::string& program, std::vector<std::string> arguments, int output, std::string purpose);
    ~Ffmpeg();
    Ffmpeg(const Ffmpeg&) = delete;
    Ffmpeg& operator=(const Ffmpeg&) = delete;

    /// The calling thread must have SIGPIPE blocked. @throws RunError with ffmpeg's message if it has stopped.
    void write(const void* data, size_t byteCount);
    /// Closes its input and waits. @throws RunError with ffmpeg's message if it failed.
    void finish();

private:
    void closeInput();
    std::string messages() const;

    std::string purpose_;
    pid_t child_ = -1;
    std::optional<Leftover> leftover_;
    int input_ = -1, log_ = -1;
};

}  // namespace knuckle
