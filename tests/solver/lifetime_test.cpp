#include <algorithm>
#include <cstring>
#include <map>
#include <random>

#include "app/bench/bench_worlds.h"
#include "sim/solver/step.h"
#include "tests/solver/determinism_worlds.h"
#include "tests/solver/solver_test.h"

namespace knuckle::test {

namespace {

constexpr int STEPS = 45, MORE = 15;  // towers sleep at the end of the first, and are woken in the second

/// A world's solver, stage by stage.
class Running {
public:
    Running(const World& worldIn, EmptyPasses empty) : world(worldIn), stages(gpu(), world), empty_(empty)
    {
        stages.load();
    }

    void start()
    {
        Recorder recorder(timer_, stages.dispatches, empty_);
        recordStart(stages, recorder);
    }
    /// @param poison whether scratch holds only NaN before each step.
    void steps(int count, bool poison = false)
    {
        for (int k = 0; k < count; ++k) {
            if (poison) poisonScratch();
            Recorder recorder(timer_, stages.dispatches, empty_);
            recordStep(stages, world.settings, recorder);
            gpu::Counters counters = stages.counters.download()[0];
            ASSERT_EQ(counters.problems & PROBLEM_NAN, 0u) << "step " << k;
            if (counters.problems == 0) continue;
            stages.grow(counters);
            counters.problems = 0;
            stages.counters.upload(std::span<const gpu::Counters>(&counters, 1));
        }
    }

    const World world;
    Stages stages;

private:
    void poisonScratch()
    {
        uint32_t poisoned = 0;
        const BufferTable buffers = stages.table();
        for (const auto& [name, entry] : buffers.entries()) {
            if (entry.lifetime != Lifetime::Scratch || entry.buffer->bytes() == 0) continue;
            const std::vector<uint32_t> nan(entry.buffer->bytes() / 4, 0xffffffffu);
            entry.buffer->write(nan.data(), entry.buffer->bytes());
            ++poisoned;
        }
        ASSERT_GT(poisoned, 10u);
    }

    const EmptyPasses empty_;
    KernelTimer timer_;
};

uint32_t wordAt(const std::vector<std::byte>& bytes, size_t at)
{
    uint32_t word;
    std::memcpy(&word, &bytes[at], sizeof word);
    return word;
}

/// Compares bit by bit.
void expectSame(const StagesState& found, const StagesState& wanted)
{
    EXPECT_GT(wanted.buffers.size(), 20u);
    for (const auto& [name, bytes] : wanted.buffers) {
        const auto& others = found.buffers.at(name);
        ASSERT_EQ(others.size(), bytes.size()) << name;
        for (size_t k = 0; k < bytes.size(); k += 4)
            EXPECT_EQ(wordAt(others, k), wordAt(bytes, k)) << name << " in word " << k / 4;
    }
}

/// Of all buffers.
std::map<std::string, std::vector<std::byte>> contentsOf(Stages& stages)
{
    std::map<std::string, std::vector<std::byte>> contents;
    const BufferTable buffers = stages.table();
    for (const auto& [name, entry] : buffers.entries()) {
        contents[name].resize(entry.buffer->bytes());
        if (entry.buffer->bytes() > 0) entry.buffer->read(contents[name].data(), entry.buffer->bytes());
    }
    return contents;
}

class LifetimeOf : public testing::TestWithParam<Matter> {};

}  // namespace

/// Another solver that gets only the state, with only NaN in scratch before each step, and leaves out empty passes.
TEST_P(LifetimeOf, StateAloneGoesOnWithTheSameBits)
{
    const World world = GetParam().world();
    Running whole(world, EmptyPasses::Dispatch), second(world, EmptyPasses::LeaveOut);
    whole.start();
    whole.steps(STEPS);
    second.stages.load(whole.stages.save());
    whole.steps(MORE);
    second.steps(MORE, true);
    expectSame(second.stages.save(), whole.stages.save());
}

TEST_P(LifetimeOf, StagesUploadInAnyOrder)
{
    const World world = GetParam().world();
    Stages natural(gpu(), world);
    for (const uint32_t seed : {1u, 2u, 3u}) {
        Stages shuffled(gpu(), world, [&](std::vector<Stage*>& stages) {
            std::mt19937 random(seed);
            for (size_t k = stages.size(); k > 1; --k) std::swap(stages[k - 1], stages[random() % k]);
        });
        EXPECT_EQ(std::memcmp(&shuffled.parameters, &natural.parameters, sizeof natural.parameters), 0);
        const auto found = contentsOf(shuffled);
        for (const auto& [name, bytes] : contentsOf(natural)) EXPECT_TRUE(found.at(name) == bytes) << name;
    }
}

TEST(Lifetime, AStateOfAnotherWorldIsRefused)
{
    const World one = table2World(20, {}), two = table2World(21, {});
    Stages stages(gpu(), one), others(gpu(), two);
    EXPECT_THROW(others.load(stages.save()), std::logic_error);
}

INSTANTIATE_TEST_SUITE_P(Matters, LifetimeOf, testing::ValuesIn(matters()),
                         [](const auto& tested) { return std::string(tested.param.name); });

}  // namespace knuckle::test
