#include "tests/solver/emitter/emitter_fixture.h"

namespace knuckle::test {

namespace {

class FluidDrain : public testing::Test {
protected:
    /// The depth of a place in the drains [m]; negative outside of all.
    double depth(const gpu::vec4& place) const
    {
        double deepest = -1e9;
        for (const Region& drain : fixture.world.drains) {
            const Vector3d p = drain.orientation.conjugate().cast<double>() *
                               (vec3(place) - drain.position).cast<double>();
            const Vector3d outside = p.cwiseAbs() - drain.halfExtents.cast<double>();
            const bool isBox = drain.shape == ColliderShape::Box;
            deepest = std::max(deepest, isBox ? -outside.maxCoeff() : drain.radius - p.norm());
        }
        return deepest;
    }

    EmitterFixture fixture;
};

TEST_F(FluidDrain, WhatIsInADrainLeavesAndTheNextStepKnowsWhoIsInactive)
{
    fixture.shuffle(441);
    fixture.deactivate(0.3f, 442);
    fixture.setTotals(100, 50);
    fill(fixture.stage().poolInactive, std::vector<uint32_t>(fixture.poolCapacity(), 0));
    fixture.runPools("emitter/fluid_drain", fixture.stages.parameters.fluidFilled + fixture.poolCapacity());
    const auto positions = fixture.stages.particles.positions.download();
    const auto velocities = fixture.stages.particles.velocities.download();
    uint32_t drained = 0;
    for (uint32_t i = 0; i < positions.size(); ++i) {
        const gpu::vec4 was = fixture.positions[i];
        ASSERT_GT(std::abs(depth(was)), 1e-6) << "particle " << i << ": rounding would decide";
        const bool leaves = i >= fixture.solidCount() && was.w == 0.0f && depth(was) > 0.0;
        ASSERT_EQ(vec3(positions[i]), vec3(was)) << "particle " << i;
        ASSERT_EQ(positions[i].w, leaves ? 1.0f : was.w) << "particle " << i;
        const Vector3f velocity = vec3(fixture.velocities[i]);
        ASSERT_EQ(vec3(velocities[i]), leaves ? Vector3f(0, 0, 0) : velocity) << "particle " << i;
        drained += leaves;
    }
    EXPECT_GT(drained, 30u);
    EXPECT_EQ(fixture.totals(), (std::vector<uint32_t>{100, 50 + drained}));
    const auto inactive = fixture.stage().poolInactive.download();
    for (uint32_t place = 0; place < fixture.poolCapacity(); ++place) {
        const uint32_t i = fixture.order[fixture.after() + place];
        const bool wanted = i != NO_INDEX && (fixture.positions[i].w != 0.0f || depth(fixture.positions[i]) > 0.0);
        ASSERT_EQ(inactive[place], wanted ? 1u : 0u) << "place " << place;
    }
}

}  // namespace

}  // namespace knuckle::test
