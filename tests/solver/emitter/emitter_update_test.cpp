#include <algorithm>
#include <cmath>

#include "tests/solver/emitter/emitter_fixture.h"

namespace knuckle::test {

namespace {

/// State of an emitter at the end of a step, in double precision.
struct Clock {
    uint64_t layers = 0;
    double age = 0.0;  ///< Since the last layer left [s].
    bool sure = true;  ///< Not so near to a layer that rounding decides.
};

class EmitterUpdate : public testing::Test {
protected:
    Clock clockOf(uint32_t k, uint32_t steps) const
    {
        const Emitter& e = fixture.emitter(k);
        const double t = steps * fixture.step(), past = (t - e.start) / e.interval();
        Clock clock;
        // Nothing leaves before the end of the first step.
        if (steps == 0 || t < e.start) return clock;
        clock.layers = e.layersUntil(t);
        clock.age = t - e.start - (static_cast<double>(clock.layers) - 1) * e.interval();
        // The clock of the kernel errs by 2^-33 of a layer a step.
        clock.sure = std::abs(past - std::round(past)) > 1e-6 + steps * 0x1p-33;
        return clock;
    }
    /// @returns whether everything was certain.
    bool expectStates(uint32_t steps)
    {
        fixture.setSteps(steps);
        fixture.runPools("emitter/emitter_update", 1);
        const auto states = fixture.stage().emitterStates.download();
        uint32_t candidates = 0;
        for (uint32_t k = 0; k < fixture.emitterCount(); ++k) {
            const Clock last = clockOf(k, steps - 1), now = clockOf(k, steps), then = clockOf(k, steps + 1);
            if (!last.sure || !now.sure || !then.sure) return false;
            const Emitter& e = fixture.emitter(k);
            const uint32_t points = fixture.pointCount(k), inactive = fixture.inactiveOf(k);
            const auto due = static_cast<uint32_t>(now.layers - last.layers);
            const auto next = static_cast<uint32_t>(then.layers - now.layers);
            const uint32_t taken = std::min(due, inactive / points) * points, left = inactive - taken;
            // The number of oldest particles that the next step lacks.
            uint32_t retired = next * points > left ? next * points - left : 0;
            retired = e.takesOldest ? std::min(retired, e.pool - inactive) : 0;
            EXPECT_EQ(states[k].taken, taken) << "emitter " << k << " in step " << steps;
            EXPECT_EQ(states[k].retired, retired) << "emitter " << k << " in step " << steps;
            EXPECT_EQ(states[k].inactive, inactive) << "emitter " << k;
            EXPECT_EQ(states[k].firstCandidate, candidates) << "emitter " << k;
            if (now.layers > 0) {
                const double error = 1e-6 * now.age + steps * 0x1p-32 * e.interval();
                EXPECT_NEAR(states[k].age, now.age, error + 1e-9) << "emitter " << k << " in step " << steps;
            }
            candidates += taken;
            most = std::max(most, retired);
            least = std::min(least, taken);
            layers[k] += due;
        }
        const auto dispatches = fixture.stages.dispatches.download();
        EXPECT_EQ(dispatches[DISPATCH_EMIT].x, groupsFor(candidates));
        const uint32_t there = fixture.solidCount() + fixture.stages.parameters.fluidFilled + 250 - 77;
        EXPECT_EQ(dispatches[DISPATCH_SLOTS].x, groupsFor(there + candidates));
        return true;
    }

    EmitterFixture fixture;
    uint32_t most = 0, least = 1000, layers[3] = {0, 0, 0};
};

TEST_F(EmitterUpdate, EachStepTakesTheLayersThatAreDueOfWhatThePoolHas)
{
    fixture.setTotals(250, 77);
    for (const float share : {0.9f, 0.1f, 0.0f}) {
        fixture.deactivate(share, 411);
        uint32_t sure = 0;
        for (uint32_t steps = 1; steps <= 180; ++steps) sure += expectStates(steps);
        EXPECT_GT(sure, 150u) << share;
    }
    EXPECT_GE(most, 8u);
    EXPECT_EQ(least, 0u);
    for (uint32_t due : layers) EXPECT_GT(due, 100u);
}

/// After 18 days the clock still has a layer's time to a thousandth.
TEST_F(EmitterUpdate, NoLayerIsLateAfterManySteps)
{
    fixture.setTotals(250, 77);
    fixture.deactivate(0.9f, 412);
    uint32_t sure = 0;
    for (uint32_t k = 0; k < 50; ++k) sure += expectStates(100000000 + 142857 * k);
    EXPECT_GT(sure, 25u);
}

}  // namespace

}  // namespace knuckle::test
