#include "render/output/frame_queue.h"

#include <csignal>

namespace knuckle {

namespace {

constexpr size_t MAX_WAITING = 3;

/// A closed pipe and a file that grew too large become errors of write() on this thread instead of killing the program.
void blockWriteSignals()
{
    sigset_t signals;
    sigemptyset(&signals);
    sigaddset(&signals, SIGPIPE);
    sigaddset(&signals, SIGXFSZ);
    pthread_sigmask(SIG_BLOCK, &signals, nullptr);
}

}  // namespace

FrameQueue::FrameQueue(Consume consume) : consume_(std::move(consume)), thread_([this] { run(); }) {}

FrameQueue::~FrameQueue()
{
    {
        const std::lock_guard lock(mutex_);
        stopping_ = true;
        waiting_.clear();
    }
    changed_.notify_all();
    thread_.join();
}

void FrameQueue::push(Image image, uint64_t number)
{
    {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [this] { return failure_ || waiting_.size() < MAX_WAITING; });
        rethrow();
        waiting_.emplace_back(std::move(image), number);
    }
    changed_.notify_all();
}

void FrameQueue::drain()
{
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return failure_ || (waiting_.empty() && !busy_); });
    rethrow();
}

void FrameQueue::rethrow()
{
    if (failure_) std::rethrow_exception(failure_);
}

void FrameQueue::run()
{
    blockWriteSignals();
    std::unique_lock lock(mutex_);
    for (;;) {
        changed_.wait(lock, [this] { return stopping_ || (!waiting_.empty() && !failure_); });
        if (stopping_) return;
        const auto [image, number] = std::move(waiting_.front());
        waiting_.pop_front();
        busy_ = true;
        lock.unlock();
        changed_.notify_all();
        std::exception_ptr failure;
        try {
            consume_(image, number);
        } catch (...) {
            failure = std::current_exception();
        }
        lock.lock();
        busy_ = false;
        failure_ = failure;
        changed_.notify_all();
    }
}

}  // namespace knuckle
