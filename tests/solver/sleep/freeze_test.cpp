#include <algorithm>

#include "tests/solver/sleep/sleep_fixture.h"

namespace knuckle::test {

namespace {

class Freeze : public testing::Test {
protected:
    Freeze()
    {
        positions = fixture.stages.particles.positions.download();
        for (gpu::vec4& p : positions) p = random.vec4(0.5f);
        fill(fixture.stages.particles.positions, positions);
        for (uint32_t m = 0; m < fixture.moverCount(); ++m) {
            oldCentres.push_back(packed(Vector3f(centre(m).cast<float>() + random.inCube(0.01f))));
            const Quaternionf turn(Eigen::AngleAxisf(random.between(0, 0.1f), random.direction()));
            oldRotations.push_back(packed(fixture.isBody(m) ? Quaternionf(turn * quaternion(fixture.rotations[m]))
                                                            : quaternion(fixture.rotations[m])));
        }
        fill(fixture.stages.sleep->calmCentres, oldCentres);
        fill(fixture.stages.sleep->calmRotations, oldRotations);
    }
    /// A loose particle has its own place; its mover may be a step behind.
    Vector3d centre(uint32_t mover) const
    {
        if (fixture.isBody(mover)) return fixture.centre(mover);
        return vec3(positions[fixture.parts[mover][0].particle]).cast<double>();
    }
    /// An upper bound of how far a mover's particles move: a chord of the turn.
    double moved(uint32_t mover) const
    {
        const Eigen::Quaterniond old = quaternion(oldRotations[mover]).cast<double>();
        const double angle = fixture.rotation(mover).angularDistance(old);
        return (centre(mover) - vec3(oldCentres[mover]).cast<double>()).norm() +
               2.0 * std::sin(0.5 * angle) * fixture.radius(mover);
    }

    SleepFixture fixture{true};
    Random random{321};
    std::vector<gpu::vec4> positions, oldCentres, oldRotations;
};

TEST_F(Freeze, AnAssemblyStartsAnewWhereOneOfItsMoversHasGoneTooFar)
{
    const double limit = fixture.stages.parameters.freeze;
    auto wanted = fixture.next;
    uint32_t turned = 0, stayed = 0, edges = 0;
    for (uint32_t m = 0; m < fixture.moverCount(); ++m) {
        if (fixture.isFixed(m) || fixture.calms[fixture.assemblyOf(m)].x == 0) continue;
        const double way = moved(m), shift = (centre(m) - vec3(oldCentres[m]).cast<double>()).norm();
        edges += std::abs(way - limit) < 1e-6;
        turned += way > limit && shift < limit;
        stayed += way < limit;
        if (way > limit) wanted[fixture.assemblyOf(m)].x = 0;
    }
    ASSERT_EQ(edges, 0u);
    EXPECT_GT(turned, 1u);
    EXPECT_GT(stayed, 50u);
    fixture.runSleep("freeze_mover", fixture.moverCount());
    fixture.expectCalms(fixture.nextCalms(), wanted);
}

TEST_F(Freeze, WhatBeginsToCountNotesWhereItIs)
{
    fixture.runSleep("freeze_mover", fixture.moverCount());
    const auto centres = fixture.stages.sleep->calmCentres.download();
    const auto rotations = fixture.stages.sleep->calmRotations.download();
    uint32_t noted = 0;
    for (uint32_t m = 0; m < fixture.moverCount(); ++m) {
        const bool notes = !fixture.isFixed(m) && fixture.calms[fixture.assemblyOf(m)].x == 0;
        const Vector3f wanted = notes ? Vector3f(centre(m).cast<float>()) : vec3(oldCentres[m]);
        ASSERT_EQ(vec3(centres[m]), wanted) << "mover " << m;
        const gpu::vec4 turn = notes ? fixture.rotations[m] : oldRotations[m];
        ASSERT_EQ(quaternion(rotations[m]).coeffs(), quaternion(turn).coeffs()) << "mover " << m;
        noted += notes;
    }
    EXPECT_GT(noted, 100u);
}

TEST_F(Freeze, StepsAreCountedUntilItFreezesAndFromZeroWhereItMoved)
{
    auto wanted = fixture.calms, fresh = fixture.next;
    for (uint32_t a = 0; a < fixture.assemblyCount(); ++a) {
        wanted[a].x = fixture.next[a].x == 0 ? 0 : std::min(wanted[a].x + 1, fixture.calmSteps());
        fresh[a].x = fixture.calmSteps();
    }
    fill(fixture.stages.sleep->islandsWoken, std::vector<uint32_t>(fixture.assemblyCount(), 1));
    fixture.forAssemblies("freeze_update");
    fixture.expectCalms(fixture.stages.sleep->assemblyCalm.download(), wanted);
    fixture.expectCalms(fixture.nextCalms(), fresh);
    for (uint32_t woken : fixture.stages.sleep->islandsWoken.download()) ASSERT_EQ(woken, 0u);
}

}  // namespace

}  // namespace knuckle::test
