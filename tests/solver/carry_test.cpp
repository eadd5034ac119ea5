#include "sim/solver/carry/carry_over.h"

#include <algorithm>
#include <cstring>
#include <numeric>

#include "sim/solver/solver.h"
#include "sim/world/match/start_world.h"
#include "tests/solver/determinism_worlds.h"
#include "tests/solver/solver_test.h"

namespace knuckle::test {

namespace {

constexpr uint64_t STEPS = 45, MORE = 6;

void advance(Solver& solver, uint64_t steps)
{
    for (uint64_t k = 0; k < steps; ++k) solver.step();
    solver.checkCounters(1);
}

std::vector<uint32_t> numbers(size_t count)
{
    std::vector<uint32_t> all(count);
    std::iota(all.begin(), all.end(), 0u);
    return all;
}

/// Of two equal worlds.
Counterparts allOf(const World& world)
{
    return {.particles = numbers(world.particles.size()),
            .bodies = numbers(world.bodies.size()),
            .softBodies = numbers(world.softBodies.size()),
            .strands = numbers(world.strands.size()),
            .emitters = numbers(world.emitters.size()),
            .colliders = numbers(world.colliders.size()),
            .kept = {},
            .added = {},
            .gone = {}};
}

/// The state with a search for contacts due.
SolverState withSearchDue(SolverState state)
{
    std::vector<std::byte>& bytes = state.stages.buffers.at("countersBlock");
    gpu::Counters counters;
    std::memcpy(&counters, bytes.data(), sizeof counters);
    counters.due = counters.freeMoved = 1;
    counters.fastLater = 0;
    std::memcpy(bytes.data(), &counters, sizeof counters);
    return state;
}

bool sleeps(const SolverState& state)
{
    const std::vector<std::byte>& bytes = state.stages.buffers.at("moverStates");
    std::vector<uint32_t> states(bytes.size() / sizeof(uint32_t));
    std::memcpy(states.data(), bytes.data(), bytes.size());
    return std::ranges::find(states, MOVER_ASLEEP) != states.end();
}

/// The mean distance of a particle of one from where the other has it [m].
float meanDistance(Solver& one, Solver& other)
{
    const auto a = one.readView().positions, b = other.readView().positions;
    float sum = 0.0f;
    for (size_t p = 0; p < a.size(); ++p) {
        EXPECT_EQ(a[p].w, b[p].w) << p;
        if (a[p].w == 0.0f) sum += Vector3f(a[p].x - b[p].x, a[p].y - b[p].y, a[p].z - b[p].z).norm();
    }
    return sum / static_cast<float>(a.size());
}

/// Boxes in a tower, and one of another name far from it. @param far before the tower, behind it, or not at all.
World tower(int far)
{
    WorldBuilder builder(DIAMETER / 2);
    builder.addMaterial({});
    builder.addCollider({});
    const auto addBox = [&](const std::string& name, const Vector3f& place) {
        builder.beginObject(name);
        builder.addBody("body", boxLattice({3, 3, 3}, DIAMETER), 0);
        builder.endObject({place}, {0, -1, 0}, {0.5f, 1, 0});
    };
    if (far < 0) addBox("far", {5, 2, 0});
    for (int k = 0; k < 5; ++k) addBox("box", {0.05f * static_cast<float>(k), 0.3f + 0.4f * static_cast<float>(k), 0});
    if (far > 0) addBox("far", {5, 2, 0});
    return builder.build();
}

class CarryOver : public testing::TestWithParam<Matter> {};

}  // namespace

TEST_P(CarryOver, ToAnEqualWorldGoesOnAlike)
{
    const World world = GetParam().world();
    if (world.settings.solver == SolverKind::Paper) GTEST_SKIP() << "the paper's solver cannot";
    const World later = atTime(world, STEPS * double{world.settings.timeStep});
    Solver whole(gpu(), world), second(gpu(), later);
    advance(whole, STEPS);
    const bool asleep = sleeps(whole.saveState());
    second.carryOver(whole, allOf(world), STEPS);
    EXPECT_EQ(second.stateHash(), whole.stateHash());
    whole.loadState(withSearchDue(whole.saveState()));
    advance(whole, MORE);
    advance(second, MORE);
    // What sleeps wakes; places of moving colliders are computed on the host, which rounds otherwise.
    if (world.colliderMotions.empty() && !asleep) {
        EXPECT_EQ(second.stateHash(), whole.stateHash());
    }
    EXPECT_LT(meanDistance(whole, second), 0.01f * world.diameter());
}

TEST_P(CarryOver, KnowsEveryBufferOfState)
{
    const World world = GetParam().world();
    Stages stages(gpu(), world);
    const std::vector<std::string> known = carriedBuffers();
    for (const auto& [name, bytes] : stages.save().buffers)
        EXPECT_EQ(std::ranges::count(known, name), 1) << name << " is not known to carriedOver(), or twice";
}

/// Whatever is new or gone beside it, and in whichever order it stands.
TEST(CarryOverTo, AnotherWorldGoesOnAlikeInWhatBothHave)
{
    for (const auto& [before, after] : {std::pair{0, -1}, {0, 1}, {-1, 0}, {1, -1}}) {
        const World one = tower(before), other = tower(after);
        const Counterparts same = counterparts(one, other);
        Solver whole(gpu(), one), second(gpu(), other);
        advance(whole, STEPS);
        second.carryOver(whole, same, STEPS);
        const auto then = whole.readView().positions, carried = second.readView().positions;
        for (size_t p = 0; p < same.particles.size(); ++p)
            EXPECT_TRUE(same.particles[p] == NO_INDEX ||
                        std::memcmp(&carried[p], &then[same.particles[p]], sizeof carried[p]) == 0)
                << p;
        whole.loadState(withSearchDue(whole.saveState()));
        advance(whole, MORE);
        advance(second, MORE);
        // Not bit by bit: what is far away has its share in when contacts are looked for.
        const auto wanted = whole.readView().positions, found = second.readView().positions;
        for (size_t p = 0; p < same.particles.size(); ++p) {
            if (same.particles[p] == NO_INDEX) continue;
            const gpu::vec4 &a = found[p], &b = wanted[same.particles[p]];
            EXPECT_LT(Vector3f(a.x - b.x, a.y - b.y, a.z - b.z).norm(), 0.01f * DIAMETER) << p;
        }
        const bool isNew = before == 0 && after != 0, isGone = before != 0 && after == 0;
        EXPECT_EQ(same.kept.size(), isNew || isGone ? 1u : 2u);
        EXPECT_EQ(same.added, isNew ? std::vector<std::string>{"far"} : std::vector<std::string>());
        EXPECT_EQ(same.gone, isGone ? std::vector<std::string>{"far"} : std::vector<std::string>());
    }
}

/// A new thing begins where its world has it, at the speed there.
TEST(CarryOverTo, NewThingsBeginWhereTheirWorldHasThem)
{
    const World one = tower(0), other = tower(1);
    Solver whole(gpu(), one), second(gpu(), other);
    advance(whole, STEPS);
    second.carryOver(whole, counterparts(one, other), STEPS);
    const std::vector<BodyState> bodies = second.readBodies();
    EXPECT_EQ(bodies.back().position, Vector3f(5, 2, 0));
    EXPECT_LT((bodies.back().velocity - Vector3f(0, -1, 0)).norm(), 1e-5f);
}

INSTANTIATE_TEST_SUITE_P(Matters, CarryOver, testing::ValuesIn(matters()),
                         [](const auto& tested) { return tested.param.name; });

}  // namespace knuckle::test
