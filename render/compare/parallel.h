#pragma once

#include <atomic>
#include <cstddef>
#include <exception>
#include <system_error>
#include <thread>
#include <vector>

namespace knuckle {

/// Calls act(i) for all i below `count`, in any order, on up to `threads` threads, this one among them. What it
/// computes must go to a place of its own for each i, so that results do not depend on the number of threads.
/// @throws the exception of the lowest i that threw.
template <typename Act>
void forEachParallel(size_t count, unsigned threads, const Act& act)
{
    std::atomic<size_t> next = 0;
    std::vector<std::exception_ptr> errors(count);
    const auto work = [&] {
        for (size_t i = next++; i < count; i = next++) {
            try {
                act(i);
            } catch (...) {
                errors[i] = std::current_exception();
            }
        }
    };
    std::vector<std::thread> others;
    try {
        while (others.size() + 1 < threads && others.size() + 1 < count) others.emplace_back(work);
    } catch (const std::system_error&) {
        // The system gives no more threads: those that run do it all.
    }
    work();
    for (std::thread& thread : others) thread.join();
    for (const std::exception_ptr& error : errors)
        if (error) std::rethrow_exception(error);
}

}  // namespace knuckle
