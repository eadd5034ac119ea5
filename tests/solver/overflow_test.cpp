#include <bit>

#include "sim/base/fnv_hash.h"
#include "sim/solver/solver.h"
#include "tests/solver/determinism_worlds.h"
#include "tests/solver/solver_test.h"

namespace knuckle::test {

namespace {

constexpr ListRoom LEAST{1, 1, 4}, PLENTY{120'000, 60'000, 400};

class Overflow : public testing::TestWithParam<Matter> {
protected:
    /// Of the state and of what pictures show. @param steps between two looks at the counters.
    static uint64_t hashOf(const World& world, const std::optional<ListRoom>& room, uint64_t steps)
    {
        Solver solver(gpu(), world, room);
        for (uint64_t k = 1; k <= 36; ++k) {
            solver.step();
            if (k % steps == 0) solver.checkCounters(k);
        }
        FnvHash hash;
        hash.add(solver.stateHash());
        const ViewState view = solver.readView();
        for (const auto* values : {&view.ages, &view.contactForces})
            for (const float value : *values) hash.add(std::bit_cast<uint32_t>(value));
        return hash.value();
    }
};

/// Steps without room for all their contacts are repeated: nothing is lost, and it does not matter when counters are
/// checked.
TEST_P(Overflow, LosesNothing)
{
    World world = GetParam().world();
    world.shown = {.ages = true, .contactForces = world.settings.solver == SolverKind::Impulse};
    const uint64_t wanted = hashOf(world, PLENTY, 1);
    EXPECT_EQ(hashOf(world, LEAST, 1), wanted) << "looked at after each step";
    EXPECT_EQ(hashOf(world, LEAST, 18), wanted) << "looked at after 18";
    EXPECT_EQ(hashOf(world, {}, 3), wanted) << "with the room by default";
}

INSTANTIATE_TEST_SUITE_P(Matters, Overflow, testing::ValuesIn(matters()),
                         [](const auto& tested) { return tested.param.name; });

}  // namespace

}  // namespace knuckle::test
