#include <algorithm>
#include <limits>

#include "tests/solver/body/mover_fixture.h"

namespace knuckle::test {

namespace {

/// Compares mover_integrate and particle_position with the motion of each particle by itself.
class MoverIntegrate : public testing::Test {
protected:
    MoverIntegrate()
    {
        Stages& b = fixture.stages;
        velocities = fixture.randomFields(2.0f, 5.0f, 91);
        oldVelocities = fixture.randomFields(2.0f, 5.0f, 92);
        oldMoves = fixture.randomFields(0.01f, 0.02f, 93);
        fill(b.bodies.moverVelocities, velocities);
        fill(b.bodies.oldMoverVelocities, oldVelocities);
        fill(b.bodies.oldMoverMoves, oldMoves);
        fixture.setMoves(0.01f, 0.05f, 3.0f);
        fixture.treatAllAsFree();
    }
    double h() const { return fixture.stages.parameters.substepTime; }
    /// Checks that every particle's new velocity is `wanted` of its move and the previous one.
    template <typename Wanted>
    void expectVelocities(Wanted wanted)
    {
        fixture.forFreeAndLoose("body/mover_integrate");
        const auto found = fixture.stages.bodies.moverVelocities.download();
        for (uint32_t m = 0; m < fixture.moverCount(); ++m) {
            for (const Part& part : fixture.parts[m]) {
                const Vector3d move = fixture.moveOf(m, part.r), last = fixture.field(oldMoves, m).at(part.r);
                const double turned = 2 * vec3(fixture.turns[m]).norm() * part.r.norm();
                const double size = vec3(fixture.moves[m]).norm() + turned + fixture.field(oldMoves, m).size(part.r);
                const Vector3d v = fixture.isFixed(m) ? Vector3d(0, 0, 0) : wanted(m, move, last);
                const double rounding = 16 * EPSILON * 1.5 * size / h();
                ASSERT_LE((fixture.field(found, m).at(part.r) - v).norm(), rounding) << "mover " << m;
            }
        }
    }

    /// Runs with a mover's move that is not a number. @returns the reported particle.
    uint32_t reportOf(uint32_t mover)
    {
        fixture.setAssemblies(0, 1);
        gpu::Counters clean = fixture.counters();
        clean.problems = clean.badParticle = 0;
        fixture.setCounters(clean);
        auto bad = fixture.moves;
        bad[mover].y = std::numeric_limits<float>::quiet_NaN();
        fill(fixture.stages.bodies.moverMoves, bad);
        fixture.forFreeAndLoose("body/mover_integrate");
        EXPECT_EQ(fixture.counters().problems, PROBLEM_NAN) << "mover " << mover;
        return fixture.counters().badParticle;
    }

    MoverFixture fixture;
    std::vector<gpu::vec4> velocities, oldVelocities, oldMoves;
};

TEST_F(MoverIntegrate, VelocitiesAreOfTheOrderOfThePrediction)
{
    fixture.setAssemblies(MoverFixture::SUBSTEP - 2, 2);
    // (3/2 x* - 2 x + 1/2 x_)/h
    expectVelocities([&](uint32_t, const Vector3d& move, const Vector3d& last) {
        return Vector3d((1.5 * move - 0.5 * last) / h());
    });
}

TEST_F(MoverIntegrate, AnAssemblyTouchedInThisSubstepAnswersByFirstOrder)
{
    fixture.setAssemblies(MoverFixture::SUBSTEP - 1, 2);  // search_due has counted this substep already
    expectVelocities([&](uint32_t, const Vector3d& move, const Vector3d&) { return Vector3d(move / h()); });
}

TEST_F(MoverIntegrate, EveryParticleEndsWhereItsMoveTookIt)
{
    fixture.setAssemblies(MoverFixture::SUBSTEP - 2, 1);
    fixture.forFreeAndLoose("body/mover_integrate");
    Stages& b = fixture.stages;
    const auto centres = b.bodies.moverCentres.download(), rotations = b.bodies.moverRotations.download();
    const auto keptMoves = b.bodies.oldMoverMoves.download(), keptVelocities = b.bodies.oldMoverVelocities.download();
    for (uint32_t m = 0; m < fixture.moverCount(); ++m) {
        const bool fixed = fixture.isFixed(m);
        for (const Part& part : fixture.parts[m]) {
            const Vector3d from = fixture.centre(m) + fixture.arm(m, part.r), move = fixture.moveOf(m, part.r);
            const Vector3d to = vec3(centres[m]).cast<double>() + quaternion(rotations[m]).cast<double>() * part.r;
            // Half a metre, rounded a few times; the rotation is normalized.
            ASSERT_LT((to - (fixed ? from : Vector3d(from + move))).norm(), 5e-7) << "mover " << m;
            const Vector3d kept = fixture.field(keptMoves, m).at(part.r);
            const Vector3d wanted = fixed ? Vector3d(0, 0, 0) : move;
            ASSERT_LT((kept - wanted).norm(), 2e-8) << "mover " << m;
        }
        const Field wanted = fixed ? Field{} : fixture.field(velocities, m);
        EXPECT_EQ(fixture.field(keptVelocities, m).t, wanted.t);
        EXPECT_EQ(fixture.field(keptVelocities, m).f, wanted.f);
    }
}

TEST_F(MoverIntegrate, WhatALimitStoppedWithoutAContactGoesOnFromThere)
{
    fixture.setAssemblies(MoverFixture::SUBSTEP - 3, 1);
    fixture.forFreeAndLoose("body/mover_integrate");
    const auto before = fixture.stages.bodies.oldMoverVelocities.download(),
               now = fixture.stages.bodies.moverVelocities.download();
    for (uint32_t m = 0; m < fixture.moverCount(); ++m)
        EXPECT_EQ(fixture.field(before, m).t, fixture.field(now, m).t) << "mover " << m;
}

TEST_F(MoverIntegrate, DampingAndTheGreatestSpeedBoundTheVelocitiesOfAllParticles)
{
    fixture.setAssemblies(0, 1);
    fixture.stages.parameters.damping = 0.5f;
    fixture.stages.parameters.maxSpeed = 1.0f;
    fixture.setParameters();
    // A body is slowed as a whole, by its farthest particle's highest possible speed: it stays rigid.
    std::vector<double> shares;
    uint32_t slowed = 0, free = 0;
    for (uint32_t m = 0; m < fixture.moverCount(); ++m) {
        const Matrix3d axes = fixture.rotation(m).toRotationMatrix();
        const Matrix3d turn = quaternion(fixture.turns[m]).cast<double>().toRotationMatrix() * axes - axes;
        const double most = 0.5 * (vec3(fixture.moves[m]).norm() + fixture.radius(m) * turn.norm()) / h();
        shares.push_back(std::min(1.0, 1.0 / most));
        (most > 1.0 ? slowed : free) += 1;
    }
    expectVelocities([&](uint32_t m, const Vector3d& move, const Vector3d&) {
        Vector3d v = shares[m] * 0.5 * move / h();
        EXPECT_LE(v.norm(), 1.0 + 1e-6) << "mover " << m;
        return v;
    });
    EXPECT_GT(slowed, 100u);
    EXPECT_GT(free, 50u);
}

TEST_F(MoverIntegrate, AVelocityThatIsNotFiniteIsReportedWithAParticleOfItsMover)
{
    for (uint32_t m : {2u, fixture.moverCount() - 7}) {
        const uint32_t reported = reportOf(m);
        const auto isReported = [&](const Part& part) { return part.particle == reported; };
        EXPECT_TRUE(std::any_of(fixture.parts[m].begin(), fixture.parts[m].end(), isReported)) << "mover " << m;
    }
}

TEST_F(MoverIntegrate, ABodyThatOwnsNoParticleAloneIsReportedWithOneThatItShares)
{
    const auto infos = fixture.stages.bodies.moverInfo.download();
    uint32_t crosses = 0;
    for (uint32_t m = 0; m < fixture.moverCount(); ++m) {
        if (infos[m].rankCount > 0) continue;
        ++crosses;
        const uint32_t reported = reportOf(m);
        const auto isReported = [&](const Part& part) { return part.particle == reported; };
        EXPECT_TRUE(std::any_of(fixture.parts[m].begin(), fixture.parts[m].end(), isReported)) << "mover " << m;
    }
    EXPECT_EQ(crosses, 1u) << "the middle of the universal joint";
}

TEST_F(MoverIntegrate, ParticlesStandAtTheMeanOfTheirBodiesGoalsWithTheMeanOfTheirVelocities)
{
    Stages& b = fixture.stages;
    const auto before = b.particles.positions.download();
    fixture.forParticles("body/particle_position");
    fixture.run("joint/joint_position", b.parameters.sharedCount);
    const auto after = b.particles.positions.download(), velocitiesAfter = b.particles.velocities.download();
    std::vector<Vector3d> places(before.size(), Vector3d::Zero()), speeds = places;
    for (uint32_t m = 0; m < fixture.moverCount(); ++m) {
        for (const Part& part : fixture.parts[m]) {
            const double share = 1.0 / std::max(fixture.world.particles[part.particle].bodyCount, 1u);
            places[part.particle] += share * (fixture.centre(m) + fixture.arm(m, part.r));
            speeds[part.particle] += share * fixture.field(velocities, m).at(part.r);
        }
    }
    uint32_t held = 0, heldByTwo = 0;
    for (uint32_t i = 0; i < after.size(); ++i) {
        if (fixture.isFixed(fixture.moverOf[i])) {
            EXPECT_EQ(vec3(after[i]), vec3(before[i])) << "particle " << i;
            EXPECT_EQ(vec3(velocitiesAfter[i]), Vector3f::Zero()) << "particle " << i;
            ++held;
            heldByTwo += fixture.world.particles[i].bodyCount > 1;
            continue;
        }
        // Half a metre and some four metres a second, rounded some eight times.
        ASSERT_LT((vec3(after[i]).cast<double>() - places[i]).norm(), 2.5e-7) << "particle " << i;
        ASSERT_LT((vec3(velocitiesAfter[i]).cast<double>() - speeds[i]).norm(), 2e-6) << "particle " << i;
    }
    EXPECT_GT(held, 24u);
    EXPECT_EQ(heldByTwo, 3u) << "of the hinge to a fixed body";
}

}  // namespace

}  // namespace knuckle::test
