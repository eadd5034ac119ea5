#pragma once

#include <httplib.h>

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

namespace knuckle {

/// Threads for connections. When all are busy and as many connections wait, no more are taken from the system, which
/// holds some and refuses the others.
class BoundedPool : public httplib::TaskQueue {
public:
    /// @throws std::system_error when the system gives no more threads.
    explicit BoundedPool(size_t threads) : most_(threads)
    {
        try {
            for (size_t k = 0; k < threads; ++k) threads_.emplace_back([this] { work(); });
        } catch (...) {
            end();  // the system gives no more threads
            throw;
        }
    }

    ~BoundedPool() override { end(); }

    /// Nothing, or in later versions of the library whether the job was taken.
    using Taken = decltype(std::declval<httplib::TaskQueue&>().enqueue({}));

    Taken enqueue(std::function<void()> job) override
    {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [&] { return jobs_.size() < most_ || ended_; });
        jobs_.push_back(std::move(job));
        lock.unlock();
        changed_.notify_all();
        return static_cast<Taken>(true);
    }

    void shutdown() override { end(); }

private:
    void end()
    {
        {
            const std::lock_guard lock(mutex_);
            ended_ = true;
        }
        changed_.notify_all();
        for (std::thread& thread : threads_) thread.join();
        threads_.clear();
    }

    void work()
    {
        while (true) {
            std::function<void()> job;
            {
                std::unique_lock lock(mutex_);
                changed_.wait(lock, [&] { return !jobs_.empty() || ended_; });
                if (jobs_.empty()) return;
                job = std::move(jobs_.front());
                jobs_.pop_front();
            }
            changed_.notify_all();
            job();
        }
    }

    size_t most_;
    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<std::function<void()>> jobs_;
    std::vector<std::thread> threads_;
    bool ended_ = false;
};

}  // namespace knuckle
