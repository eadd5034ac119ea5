#include "sim/gpu/all_cores.h"

#include <fmt/format.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <filesystem>
#include <mutex>
#include <set>
#include <thread>

#include "sim/base/cores.h"
#include "sim/base/errors.h"
#include "sim/base/memory.h"
#include "sim/gpu/kernel.h"
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

/// Mesa 22.3 damages its heap if two contexts use a texture for the first time at once. With MALLOC_PERTURB_, which
/// overwrites what is freed, it then hangs or crashes in two of three runs.
TEST(AllCores, CompileForTheSameNewBuffersAtOnce)
{
    if (usableCores() < 2 || addressSpaceLimit()) GTEST_SKIP() << "one thread compiles";
    constexpr uint32_t ROUNDS = 150, BUFFERS = 12;
    std::string declarations, sum;
    for (uint32_t b = 0; b < BUFFERS; ++b) {
        declarations += fmt::format("uniform usamplerBuffer given{};\n", b);
        sum += fmt::format(" + texelFetch(given{}, 0).x", b);
    }
    gpu();
    std::filesystem::create_directories(test::shaderFolder().path("sim"));
    test::shaderFolder().write("sim/test_sum.comp", "#include \"shared/constants.h\"\n"
                                                    "layout(local_size_x = GROUP_SIZE) in;\n" +
                                                        declarations +
                                                        "layout(std430) buffer Taken { uint taken[]; };\n"
                                                        "void main() { taken[0] = 0u" +
                                                        sum + "; }\n");
    for (uint32_t round = 0; round < ROUNDS; ++round) {
        std::vector<Buffer<uint32_t>> given(BUFFERS);
        Buffer<uint32_t> taken("taken", 1);
        BufferTable table;
        for (uint32_t b = 0; b < BUFFERS; ++b) {
            given[b] = Buffer<uint32_t>(fmt::format("given{}", b), 100);
            table.add(Lifetime::Scratch, given[b]);
        }
        table.add(Lifetime::Scratch, taken);
        const Kernel kernel(gpu(), table, "sim/test_sum.comp");
        std::atomic<uint32_t> here = 0;
        makeOnAllCores(gpu(), 2, [&](size_t, const Gpu&) {
            ++here;
            const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(200);
            while (here < 2 && std::chrono::steady_clock::now() < end) continue;
            kernel.compile();
        });
        KernelTimer timer;
        kernel.dispatch(timer, 1);
        ASSERT_EQ(taken.download()[0], 0u);
    }
}

}  // namespace
}  // namespace knuckle
