#include <algorithm>

#include "tests/solver/emitter/emitter_fixture.h"

namespace knuckle::test {

namespace {

class PoolOrder : public testing::Test {
protected:
    /// Takes a third of the inactive particles of each pool, and takes back some of the oldest.
    std::vector<gpu::EmitterState> someStates() const
    {
        std::vector<gpu::EmitterState> states(fixture.emitterCount());
        for (uint32_t k = 0; k < states.size(); ++k) {
            states[k].inactive = fixture.inactiveOf(k);
            states[k].taken = states[k].inactive / 3;
            states[k].retired = k == 1 ? std::min(11u, fixture.emitter(k).pool - states[k].inactive) : 0;
        }
        return states;
    }
    /// Checks the lists after the step, and which particles have been taken back.
    void expectOrder(uint32_t steps)
    {
        fixture.setSteps(steps);
        fixture.shuffle(420 + steps);
        fixture.deactivate(0.4f, 430 + steps);
        fixture.setTotals(5, 3);
        const auto states = someStates();
        fixture.setStates(states);
        fixture.runPools("emitter/pool_order", fixture.poolCapacity() / SCAN_CHUNK);
        const auto found = fixture.stage().poolOrder.download();
        auto wanted = fixture.order;
        std::vector<uint32_t> retired;
        for (uint32_t k = 0; k < states.size(); ++k) {
            std::vector<uint32_t> list, active;
            for (uint32_t j = fixture.poolStart(k); j < fixture.poolStart(k) + fixture.emitter(k).pool; ++j)
                (fixture.inactive[j] != 0 ? list : active).push_back(fixture.order[fixture.before() + j]);
            retired.insert(retired.end(), active.begin(), active.begin() + states[k].retired);
            list.insert(list.end(), active.begin(), active.end());
            // Particles that the step emits are the youngest from now on.
            std::rotate(list.begin(), list.begin() + states[k].taken, list.end());
            std::copy(list.begin(), list.end(), wanted.begin() + fixture.after() + fixture.poolStart(k));
        }
        ASSERT_EQ(found, wanted);
        expectRetired(retired);
    }
    void expectRetired(const std::vector<uint32_t>& retired)
    {
        const auto positions = fixture.stages.particles.positions.download();
        const auto velocities = fixture.stages.particles.velocities.download();
        for (uint32_t i = 0; i < positions.size(); ++i) {
            const bool gone = std::find(retired.begin(), retired.end(), i) != retired.end();
            ASSERT_EQ(positions[i].w, gone ? 1.0f : fixture.positions[i].w) << "particle " << i;
            const Vector3f velocity = vec3(fixture.velocities[i]);
            ASSERT_EQ(vec3(velocities[i]), gone ? Vector3f(0, 0, 0) : velocity) << "particle " << i;
        }
        EXPECT_EQ(retired.size(), 11u);
        EXPECT_EQ(fixture.totals(), (std::vector<uint32_t>{5, 3 + 11}));
    }

    EmitterFixture fixture;
};

TEST_F(PoolOrder, InactiveOnesComeFirstAndWhatIsEmittedGoesToTheEnd)
{
    expectOrder(7);
}

TEST_F(PoolOrder, TheHalvesOfTheListTakeTurns)
{
    expectOrder(8);
}

}  // namespace

}  // namespace knuckle::test
