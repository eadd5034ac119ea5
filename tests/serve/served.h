#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

namespace knuckle::test {

/// The program while it serves a scene on a free port of this machine.
class Served {
public:
    /// Waits until it listens. @throws std::runtime_error with what it said if it does not.
    Served(const std::string& scene, const std::vector<std::string>& options);
    ~Served();
    Served(const Served&) = delete;
    Served& operator=(const Served&) = delete;

    const std::string& address() const { return address_; }
    /// Ends it as Ctrl-C does. @returns all that it wrote after the first line.
    std::string end();

private:
    bool read();

    pid_t process_ = -1;
    int output_ = -1;
    std::string address_, unread_;
};

}  // namespace knuckle::test
