#include "sim/gpu/all_cores.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <memory>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

#include "sim/base/cores.h"
#include "sim/base/errors.h"
#include "sim/base/memory.h"

namespace knuckle {

namespace {

/// More threads than this wait for each other in the driver.
constexpr size_t MOST_THREADS = 16;

/// What the threads take from.
class Work {
public:
    Work(size_t count, const std::function<void(size_t, const Gpu&)>& make) : count_(count), make_(make) {}

    void takeAll(const Gpu& gpu)
    {
        for (size_t i = next_++; i < count_; i = next_++) {
            try {
                make_(i, gpu);
            } catch (...) {
                fail(i);
            }
        }
    }
    void rethrow() const
    {
        if (failure_) std::rethrow_exception(failure_);
    }

private:
    void fail(size_t i)
    {
        const std::lock_guard lock(mutex_);
        if (i >= failed_) return;
        failed_ = i;
        failure_ = std::current_exception();
    }

    const size_t count_;
    const std::function<void(size_t, const Gpu&)>& make_;
    std::atomic<size_t> next_ = 0;
    std::mutex mutex_;
    size_t failed_ = SIZE_MAX;
    std::exception_ptr failure_;
};

using Contexts = std::vector<std::unique_ptr<Gpu>>;

/// As many contexts beside `gpu`'s as can be had, at most `count`.
Contexts contextsBeside(const Gpu& gpu, size_t count)
{
    Contexts contexts;
    try {
        while (contexts.size() < count) contexts.push_back(Gpu::sharingWith(gpu));
    } catch (const std::exception&) {
        // There is no further context: the others do its part.
    }
    return contexts;
}

void workBeside(Work& work, const Gpu& own)
{
    try {
        own.enter();
        work.takeAll(own);
        glFinish();  // before another context uses what was made
        own.leave();
    } catch (const std::exception&) {
        // The driver refuses: the others do its part.
    }
}

}  // namespace

void makeOnAllCores(const Gpu& gpu, size_t count, const std::function<void(size_t, const Gpu&)>& make)
{
    Work work(count, make);
    const size_t wanted = std::min({size_t{usableCores()}, count, MOST_THREADS});
    // Made here and ended here, while no other thread uses GL: drivers are least tried there.
    const Contexts others = contextsBeside(gpu, wanted > 1 && !addressSpaceLimit() ? wanted - 1 : 0);
    std::vector<std::thread> threads;
    try {
        for (const auto& own : others) threads.emplace_back([&] { workBeside(work, *own); });
    } catch (const std::system_error&) {
        // No more threads are allowed: those that run do it.
    }
    work.takeAll(gpu);
    for (std::thread& thread : threads) thread.join();
    work.rethrow();
}

}  // namespace knuckle
