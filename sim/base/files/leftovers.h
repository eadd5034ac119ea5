#pragma once

#include <sys/types.h>

#include <string>

namespace knuckle {

/// A temporary file or a started program that must not outlive this program. clearLeftovers() knows it until it is
/// destroyed, which by itself removes and ends nothing.
class Leftover {
public:
    /// @param temporaryFile an absolute path.
    explicit Leftover(const std::string& temporaryFile);
    explicit Leftover(pid_t child);
    ~Leftover();
    Leftover(const Leftover&) = delete;
    Leftover& operator=(const Leftover&) = delete;

private:
    int place_ = -1;
};

/// Kills the programs and removes the files of all Leftovers; for a signal handler that ends the program at once.
void clearLeftovers();

}  // namespace knuckle
