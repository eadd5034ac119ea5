#include "app/serve/web/latest.h"

#include <utility>

namespace knuckle {

void Latest::put(std::string bytes)
{
    auto shared = std::make_shared<const std::string>(std::move(bytes));
    {
        const std::lock_guard lock(mutex_);
        shown_ = {std::move(shared), shown_.number + 1};
    }
    changed_.notify_all();
}

Latest::Shown Latest::next(uint64_t after, std::chrono::milliseconds longest)
{
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, longest, [&] { return closed_ || shown_.number > after; });
    return shown_;
}

void Latest::close()
{
    {
        const std::lock_guard lock(mutex_);
        closed_ = true;
    }
    changed_.notify_all();
}

bool Latest::isClosed()
{
    const std::lock_guard lock(mutex_);
    return closed_;
}

}  // namespace knuckle
