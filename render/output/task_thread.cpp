#include "render/output/task_thread.h"

#include <csignal>
#include <utility>

namespace knuckle {

namespace {

/// Turns a closed pipe, or a file that grows too large, into an error of write() on this thread instead of a fatal
/// signal.
void blockWriteSignals()
{
    sigset_t signals;
    sigemptyset(&signals);
    sigaddset(&signals, SIGPIPE);
    sigaddset(&signals, SIGXFSZ);
    pthread_sigmask(SIG_BLOCK, &signals, nullptr);
}

}  // namespace

TaskThread::TaskThread(size_t most, Task last) : most_(most), last_(std::move(last)), thread_([this] { run(); }) {}

TaskThread::~TaskThread()
{
    {
        const std::lock_guard lock(mutex_);
        stopping_ = true;
    }
    changed_.notify_all();
    thread_.join();
}

void TaskThread::waitForRoom()
{
    waitForAtMost(most_ - 1);
}

void TaskThread::push(Task task)
{
    waitForRoom();
    {
        const std::lock_guard lock(mutex_);
        waiting_.push_back(std::move(task));
        ++unfinished_;
    }
    changed_.notify_all();
}

void TaskThread::drain()
{
    waitForAtMost(0);
}

void TaskThread::waitForAtMost(size_t unfinished)
{
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return failure_ || unfinished_ <= unfinished; });
    if (failure_) std::rethrow_exception(failure_);
}

void TaskThread::run()
{
    blockWriteSignals();
    std::unique_lock lock(mutex_);
    for (;;) {
        changed_.wait(lock, [this] { return stopping_ || (!waiting_.empty() && !failure_); });
        if (stopping_) break;
        std::exception_ptr failure;
        {
            const Task task = std::move(waiting_.front());
            waiting_.pop_front();
            lock.unlock();
            try {
                task();
            } catch (...) {
                failure = std::current_exception();
            }
        }
        lock.lock();
        --unfinished_;
        failure_ = failure;
        changed_.notify_all();
    }
    lock.unlock();
    if (last_) last_();
}

}  // namespace knuckle
