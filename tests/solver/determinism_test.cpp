#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "app/bench/bench_worlds.h"
#include "shared/state_hash.h"
#include "sim/solver/solver.h"
#include "tests/solver/determinism_worlds.h"
#include "tests/solver/solver_test.h"

namespace knuckle::test {

namespace {

/// Ten of them fall on the first layer of fifty.
constexpr uint32_t OBJECTS = 60;
constexpr int STEPS = 60, PAPER_STEPS = 30;  // those of the paper's solver take ten times as long
/// Set in a child process: the way of solving that it runs.
constexpr const char* WAY_VARIABLE = "KNUCKLE_TEST_WAY";
const std::string MARK = "state hash ";

/// Ways of solving that share few kernels.
enum Way {
    DEFAULT,
    HASH,
    PAPER,
    GROUPS,
    SOFT,
    ROWS,
    FLUIDS,
    EMITTERS,
    LIMITS,
    BOUNCES,
    SLEEP,
    FREEZE,
    ROUNDS,
    GRIDS,
    HELD,
    LET_GO,
    ALL_BY_HASH,
    WINDY,
    WAYS
};

Settings settingsOf(int way)
{
    Settings settings;
    if (way == PAPER || way == GROUPS) settings = paperSettings();
    if (way == HASH) settings.grid = GridKind::Hash;
    if (way == GROUPS) settings.reduction = ReductionKind::Group;
    return settings;
}

World worldOf(int way)
{
    if (way == EMITTERS) return emitterWorld();
    if (way == FLUIDS) return fluidWorld();
    if (way == SOFT) return softWorld();
    if (way == ROWS) return ropeWorld();
    if (way == LIMITS) return limitedWorld();
    if (way == BOUNCES) return bouncyWorld();
    if (way == SLEEP || way == FREEZE) return sleepyWorld(way == FREEZE ? 0.5f : 0.0f);
    if (way == ROUNDS) return roundWorld();
    if (way == GRIDS) return gridWorld();
    if (way == HELD) return heldWorld();
    if (way == LET_GO) return animatedWorld();
    if (way == WINDY) return windyWorld();
    if (way == ALL_BY_HASH) return everyWorld(GridKind::Hash);
    World world = table2World(OBJECTS, settingsOf(way));
    // One of them is shot into the others, fast enough to look further for contacts than they do.
    for (Particle& p : world.particles)
        if (world.bodies[p.body].object == OBJECTS - 1) p.velocity = {-3.0f, -8.0f, -6.0f};
    return world;
}

uint64_t hashOfPile(int way)
{
    const World world = worldOf(way);
    Solver solver(gpu(), world);
    for (int k = 0; k < (way == PAPER || way == GROUPS ? PAPER_STEPS : STEPS); ++k) {
        solver.step();
        solver.checkCounters(static_cast<uint64_t>(k));
    }
    EXPECT_GT(solver.measure().contactCount, 0u) << "nothing has landed: the hash would prove little";
    // Points of foam are no part of that hash; their order in the ring must be the same, too.
    uint32_t foam = 0;
    for (const gpu::vec4& p : solver.readView().foamPlaces)
        for (const float value : {p.x, p.y, p.z, p.w}) foam = gpu::mixedHash(foam, std::bit_cast<uint32_t>(value));
    EXPECT_TRUE(foam != 0 || (way != FLUIDS && way != EMITTERS));
    return solver.stateHash() + foam;
}

/// Output of this program running the disabled test below with `threads` driver threads.
std::string runChild(int way, int threads)
{
    const std::string self = std::filesystem::read_symlink("/proc/self/exe").string();
    const std::string command = fmt::format(
        "env -u GTEST_TOTAL_SHARDS -u GTEST_SHARD_INDEX LP_NUM_THREADS={} {}={} '{}' --gtest_also_run_disabled_tests "
        "--gtest_filter=Determinism.DISABLED_InAChildProcess 2>&1",
        threads, WAY_VARIABLE, way, self);
    std::string output;
    FILE* pipe = popen(command.c_str(), "r");
    if (pipe == nullptr) return "cannot run " + command;
    char part[256];
    while (fgets(part, sizeof part, pipe) != nullptr) output += part;
    pclose(pipe);
    return output;
}

class DeterminismOf : public testing::TestWithParam<int> {};

TEST_P(DeterminismOf, APileHasTheSameBitsTwiceAndAtAnyNumberOfDriverThreads)
{
    const uint64_t first = hashOfPile(GetParam());
    EXPECT_EQ(hashOfPile(GetParam()), first) << "twice in one process";
    for (int threads : {0, 1, 2}) {
        const std::string output = runChild(GetParam(), threads);
        EXPECT_NE(output.find(fmt::format("{}{:016x}", MARK, first)), std::string::npos)
            << "wanted " << fmt::format("{:016x}", first) << " with LP_NUM_THREADS=" << threads << ":\n"
            << output;
    }
}

std::string wayName(const testing::TestParamInfo<int>& way)
{
    static constexpr const char* NAMES[WAYS] = {
        "Default", "Hash",  "Paper",  "PaperInGroups", "Soft",  "Strands", "Fluids", "Emitters",  "Limits",
        "Bounces", "Sleep", "Freeze", "Rounds",        "Grids", "Held",    "LetGo",  "AllByHash", "Windy"};
    return NAMES[way.param];
}

INSTANTIATE_TEST_SUITE_P(Ways, DeterminismOf, testing::Range(0, int(WAYS)), wayName);

TEST(Determinism, DISABLED_InAChildProcess)
{
    const char* way = getenv(WAY_VARIABLE);
    ASSERT_NE(way, nullptr);
    fmt::print("{}{:016x}\n", MARK, hashOfPile(std::stoi(way)));
}

/// Otherwise their hashes would prove little.
TEST(Determinism, ChainsTearAndTowersSleepAndWakeInItsWorlds)
{
    const World limited = limitedWorld();
    Solver tearing(gpu(), limited);
    for (int k = 0; k < STEPS; ++k) tearing.step();
    const std::vector<bool> torn = tearing.readParticles().torn;
    const auto gone = std::count(torn.begin(), torn.end(), true);
    EXPECT_GT(gone, 0);
    EXPECT_LE(gone, 6) << "of the three joints of one chain; the one that hangs holds";

    const World sleepy = sleepyWorld(0.0f);
    Solver sleeping(gpu(), sleepy);
    const auto sleepers = [&] {
        const auto bodies = sleeping.readBodies();
        return std::count_if(bodies.begin(), bodies.end(), [](const BodyState& b) { return b.velocity.norm() == 0; });
    };
    for (int k = 0; k < 45; ++k) sleeping.step();
    EXPECT_EQ(sleepers(), 9);
    for (int k = 45; k < STEPS; ++k) sleeping.step();
    // One tower is awake, and a second one if a box that falls off the first gets that far.
    EXPECT_GE(sleepers(), 3);
    EXPECT_LE(sleepers(), 6);
}

TEST(Determinism, ChainsAreLetGoForEachReasonInItsWorlds)
{
    const World world = animatedWorld();
    Solver solver(gpu(), world);
    for (int k = 0; k < STEPS; ++k) solver.step();
    std::vector<uint32_t> objects(world.objects.size(), 0);
    for (const LetGo& gone : solver.letGo()) {
        ++objects[world.bodies[gone.body].object];
        EXPECT_GT(gone.substep, 0u);
    }
    EXPECT_EQ(std::vector(objects.begin(), objects.begin() + 4), (std::vector<uint32_t>{3, 3, 1, 3}));
}

TEST(Determinism, OneBitOfOnePositionChangesTheHash)
{
    World world = table2World(4);
    Solver same(gpu(), world), again(gpu(), world);
    EXPECT_EQ(same.stateHash(), again.stateHash());
    float& x = world.particles.back().position.x();
    x = std::nextafter(x, 1e9f);
    Solver other(gpu(), world);
    EXPECT_NE(other.stateHash(), same.stateHash());
}

}  // namespace

}  // namespace knuckle::test
