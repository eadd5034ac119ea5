#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>

namespace knuckle {

/// The newest text or picture that one thread makes and others wait for. Who is slow misses what came in between, and
/// holds nobody up.
class Latest {
public:
    struct Shown {
        std::shared_ptr<const std::string> bytes;  ///< Null: there is none yet.
        uint64_t number = 0;                       ///< 1 for the first.
    };

    void put(std::string bytes);
    /// Waits for a newer one than `after`, as long as that; then the last one is given again.
    Shown next(uint64_t after, std::chrono::milliseconds longest);
    /// Ends all waits, now and later.
    void close();
    bool isClosed();

private:
    std::mutex mutex_;
    std::condition_variable changed_;
    Shown shown_;
    bool closed_ = false;
};

}  // namespace knuckle
