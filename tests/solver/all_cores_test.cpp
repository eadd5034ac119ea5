#include "sim/gpu/all_cores.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <set>
#include <thread>

#include "sim/base/cores.h"
#include "sim/base/errors.h"
#include "sim/base/memory.h"
#include "sim/gpu/buffer.h"
#include "tests/solver/solver_test.h"

namespace knuckle {
namespace {

using test::gpu;

constexpr uint32_t COUNT = 20;

TEST(AllCores, WhatEachThreadMakesIsSeenByTheCaller)
{
    std::vector<Buffer<uint32_t>> made(COUNT);
    std::mutex mutex;
    std::condition_variable changed;
    std::set<std::thread::id> threads;
    const std::thread::id caller = std::this_thread::get_id();
    // The first to come waits for a second, so that the caller does not do it all before that has a context.
    const size_t wanted = usableCores() > 1 && !addressSpaceLimit() ? 2 : 1;
    makeOnAllCores(gpu(), COUNT, [&](size_t i, const Gpu& own) {
        {
            std::unique_lock lock(mutex);
            threads.insert(std::this_thread::get_id());
            changed.notify_all();
            if (i == 0) changed.wait_for(lock, std::chrono::seconds(20), [&] { return threads.size() >= wanted; });
        }
        EXPECT_EQ(&own == &gpu(), std::this_thread::get_id() == caller);
        const std::vector<uint32_t> content = {static_cast<uint32_t>(i)};
        made[i] = Buffer<uint32_t>("made", std::span<const uint32_t>(content));
    });
    EXPECT_GE(threads.size(), wanted);
    for (uint32_t i = 0; i < COUNT; ++i) EXPECT_EQ(made[i].download(), std::vector<uint32_t>{i});
}

TEST(AllCores, TheFirstOfSeveralErrorsIsTold)
{
    std::atomic<uint32_t> calls = 0;
    const auto make = [&](size_t i, const Gpu&) {
        ++calls;
        if (i % 7 == 3) throw RunError(std::to_string(i));
    };
    EXPECT_EQ(test::messageOf<RunError>([&] { makeOnAllCores(gpu(), COUNT, make); }), "3");
    EXPECT_EQ(calls, COUNT);
    makeOnAllCores(gpu(), 0, make);
    EXPECT_EQ(calls, COUNT);
}

}  // namespace
}  // namespace knuckle
