#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>

namespace knuckle {

/// Runs tasks on a thread of its own, in order. What a task throws ends the work, and is thrown again by whatever is
/// called next.
class TaskThread {
public:
    using Task = std::function<void()>;

    /// @param most tasks that are unfinished at a time, so that memory stays bounded. @param last runs on the thread
    /// before it ends, whatever happened; must not throw.
    explicit TaskThread(size_t most, Task last = {});
    /// Drops what still waits, and waits for what runs.
    ~TaskThread();
    TaskThread(const TaskThread&) = delete;
    TaskThread& operator=(const TaskThread&) = delete;

    /// Waits until another task may come.
    void waitForRoom();
    /// Waits for room as well.
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
    size_t unfinished_ = 0;  ///< Those that wait, and one that runs.
    std::exception_ptr failure_;
    bool stopping_ = false;
    std::thread thread_;
};

}  // namespace knuckle
