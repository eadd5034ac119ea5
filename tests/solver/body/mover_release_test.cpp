#include <algorithm>

#include "tests/solver/joint/joined_world.h"
#include "tests/solver/solver_test.h"

namespace knuckle::test {

namespace {

/// Ten bodies that are let go in the substeps 1, 2, 3 ... ; every third one is not held.
World heldWorld()
{
    World world = joinedWorld(70, {{0, 1}, {1, 2}}, {});
    const float substep = world.settings.timeStep / static_cast<float>(world.settings.substeps);
    for (uint32_t b = 0; b < world.bodies.size(); ++b) {
        if (b % 3 == 0) continue;
        world.bodies[b].motion = Motion::Fixed;
        world.bodies[b].releaseTime = static_cast<float>(b) * substep;
    }
    return world;
}

}  // namespace

TEST(MoverRelease, LetsGoOfABodyInTheSubstepThatIsItsTime)
{
    KernelFixture fixture(heldWorld());
    const uint32_t count = fixture.stages.parameters.releaseCount;
    EXPECT_EQ(count, 46u);
    for (const uint32_t substep : {1u, 2u, 68u}) {
        gpu::Counters now{};
        now.substep = substep;
        fixture.setCounters(now);
        const auto before = fixture.stages.bodies.moverStates.download();
        fixture.run("body/mover_release", count);
        const auto after = fixture.stages.bodies.moverStates.download();
        for (uint32_t b = 0; b < after.size(); ++b)
            EXPECT_EQ(after[b], b == substep ? MOVER_DYNAMIC : before[b]) << "body " << b << " in substep " << substep;
        EXPECT_EQ(fixture.counters().due, 1u);
        // Bodies start with first order after their release.
        const auto infos = fixture.stages.bodies.moverInfo.download();
        EXPECT_EQ(fixture.stages.particles.assemblyState.download()[infos[substep].assembly].x, substep - 1);
    }
}

TEST(MoverRelease, DoesNothingInOtherSubsteps)
{
    KernelFixture fixture(heldWorld());
    for (const uint32_t substep : {0u, 3u, 70u}) {
        gpu::Counters now{};
        now.substep = substep;
        fixture.setCounters(now);
        const auto before = fixture.stages.bodies.moverStates.download();
        fixture.run("body/mover_release", fixture.stages.parameters.releaseCount);
        EXPECT_EQ(fixture.stages.bodies.moverStates.download(), before);
        EXPECT_EQ(fixture.counters().due, 0u);
    }
}

}  // namespace knuckle::test
