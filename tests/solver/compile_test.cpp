// What is compiled before the first step, by the size of Mesa's cache.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "app/bench/bench_worlds.h"
#include "sim/solver/solver.h"
#include "tests/solver/solver_test.h"
#include "tests/temp_folder.h"

namespace knuckle::test {
namespace {

constexpr const char* STEPS_VARIABLE = "KNUCKLE_TEST_STEPS";

/// Bytes in the cache of a process that takes so many steps, and began without one.
double compiledFor(int steps)
{
    const TempFolder cache;
    const std::string self = std::filesystem::read_symlink("/proc/self/exe").string();
    const std::string command = fmt::format(
        "env -u GTEST_TOTAL_SHARDS -u GTEST_SHARD_INDEX -u MESA_SHADER_CACHE_DISABLE MESA_SHADER_CACHE_DIR='{}' {}={} "
        "'{}' --gtest_also_run_disabled_tests --gtest_filter=Compile.DISABLED_InAChildProcess >/dev/null 2>&1",
        cache.path(""), STEPS_VARIABLE, steps, self);
    EXPECT_EQ(std::system(command.c_str()), 0) << command;
    double bytes = 0.0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(cache.path("")))
        if (entry.is_regular_file() && entry.path().filename() != "index")
            bytes += static_cast<double>(entry.file_size());
    return bytes;
}

/// What kernels are compiled for is what they are bound to later.
TEST(Compile, LeavesNothingForTheFirstStep)
{
    if (!gpu().device().software) GTEST_SKIP() << "another driver's cache";
    const double before = compiledFor(0), all = compiledFor(2);
    EXPECT_GT(before, 50e3);
    EXPECT_NEAR(all, before, 0.02 * before) << "a kernel that is compiled twice is a fortieth of it";
}

TEST(Compile, DISABLED_InAChildProcess)
{
    const char* steps = getenv(STEPS_VARIABLE);
    ASSERT_NE(steps, nullptr);
    const World world = table2World(4, {});
    Solver solver(gpu(), world);
    for (int k = 0; k < std::atoi(steps); ++k) solver.step();
    solver.checkCounters(1);
}

}  // namespace
}  // namespace knuckle::test
