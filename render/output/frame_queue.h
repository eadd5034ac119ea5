#pragma once

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <utility>

#include "render/picture/image.h"

namespace knuckle {

/// Hands frames to a thread of its own, in order. At most a few wait: memory stays bounded when the disk is slow.
class FrameQueue {
public:
    using Consume = std::function<void(const Image&, uint64_t number)>;

    explicit FrameQueue(Consume consume);
    /// Drops what still waits.
    ~FrameQueue();
    FrameQueue(const FrameQueue&) = delete;
    FrameQueue& operator=(const FrameQueue&) = delete;

    /// Blocks while the queue is full. Rethrows what `consume` threw.
    void push(Image image, uint64_t number);
    /// Waits for everything pushed. Rethrows what `consume` threw.
    void drain();

private:
    void run();
    void rethrow();

    Consume consume_;
    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<std::pair<Image, uint64_t>> waiting_;
    std::exception_ptr failure_;
    bool busy_ = false, stopping_ = false;
    std::thread thread_;
};

}  // namespace knuckle
