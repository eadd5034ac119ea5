#include "app/serve/web/inbox.h"

#include <algorithm>
#include <utility>

namespace knuckle {

bool Inbox::put(const Input& input)
{
    {
        const std::lock_guard lock(mutex_);
        const Clock::time_point now = Clock::now();
        const std::chrono::duration<double> passed = now - std::exchange(counted_, now);
        allowed_ = std::min(MOST_A_SECOND, allowed_ + MOST_A_SECOND * passed.count());
        if (allowed_ < 1.0 || inputs_.size() >= MOST_WAITING) return false;
        allowed_ -= 1.0;
        inputs_.push_back(input);
    }
    changed_.notify_all();
    return true;
}

std::vector<Input> Inbox::take()
{
    const std::lock_guard lock(mutex_);
    woken_ = false;
    return std::exchange(inputs_, {});
}

void Inbox::wait(std::chrono::microseconds longest)
{
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, longest, [&] { return woken_ || !inputs_.empty(); });
}

void Inbox::wake()
{
    {
        const std::lock_guard lock(mutex_);
        woken_ = true;
    }
    changed_.notify_all();
}

}  // namespace knuckle
