#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>

namespace knuckle {

/// Runs tasks on a separate thread, in order. An exception of a task ends the work, and the next call throws it again.
class TaskThread {
public:
    using Task = std::function<void()>;

    /// @param most unfinished tasks at a time, so that memory stays bounded. @param last runs on the thread before it
    /// ends, in any case; must not throw.
    explicit TaskThread(size_t most, Task last = {});
    /// Drops waiting tasks, and waits for the running one.
    ~TaskThread();
    TaskThread(const TaskThread&) = delete;
    TaskThread& operator=(const TaskThread&) = delete;

    /// Waits until there is room for another task.
    void waitForRoom();
    /// Adds a task, after waiting for room.
    void push(Task task);
    /// Waits for everything pushed.
    void drain();

private:
    void run();
    void waitForAtMost(size_t unfinished);

    const size_t most_;
    const Task last_;
    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<Task> waiting_;
    size_t unfinished_ = 0;  ///< Waiting tasks, and the running one.
    std::exception_ptr failure_;
    bool stopping_ = false;
    std::thread thread_;
};

}  // namespace knuckle
