#include <algorithm>
#include <limits>

#include "tests/solver/body/mover_bench.h"

namespace knuckle::test {

namespace {

/// mover_finish and particle_place against what each particle by itself would do.
class MoverFinish : public testing::Test {
protected:
    MoverFinish()
    {
        SolverBuffers& b = bench.buffers;
        velocities = bench.randomFields(2.0f, 5.0f, 91);
        oldVelocities = bench.randomFields(2.0f, 5.0f, 92);
        oldMoves = bench.randomFields(0.01f, 0.02f, 93);
        fill(b.moverVelocities, velocities);
        fill(b.oldMoverVelocities, oldVelocities);
        fill(b.oldMoverMoves, oldMoves);
        bench.setMoves(0.01f, 0.05f, 3.0f);
    }
    double h() const { return bench.buffers.parameters.substepTime; }
    /// Every particle's new velocity is `wanted` of the move it makes and the one before.
    template <typename Wanted>
    void expectVelocities(Wanted wanted)
    {
        bench.forMovers("body/mover_finish");
        const auto found = bench.buffers.moverVelocities.download();
        for (uint32_t m = 0; m < bench.moverCount(); ++m) {
            for (const Part& part : bench.parts[m]) {
                const Vector3d move = bench.moveOf(m, part.r), last = bench.field(oldMoves, m).at(part.r);
                const double turned = 2 * vec3(bench.turns[m]).norm() * part.r.norm();
                const double size = vec3(bench.moves[m]).norm() + turned + bench.field(oldMoves, m).size(part.r);
                const Vector3d v = bench.isFixed(m) ? bench.field(velocities, m).at(part.r) : wanted(m, move, last);
                const double rounding = 16 * EPSILON * 1.5 * size / h();
                ASSERT_LE((bench.field(found, m).at(part.r) - v).norm(), rounding) << "mover " << m;
            }
        }
    }

    /// Runs with a mover's move that is not a number. @returns the particle that is reported.
    uint32_t reportOf(uint32_t mover)
    {
        bench.setAssemblies(0, 1);
        gpu::Counters clean = bench.counters();
        clean.problems = clean.badParticle = 0;
        bench.setCounters(clean);
        auto bad = bench.moves;
        bad[mover].y = std::numeric_limits<float>::quiet_NaN();
        fill(bench.buffers.moverMoves, bad);
        bench.forMovers("body/mover_finish");
        EXPECT_EQ(bench.counters().problems, PROBLEM_NAN) << "mover " << mover;
        return bench.counters().badParticle;
    }

    MoverBench bench;
    std::vector<gpu::vec4> velocities, oldVelocities, oldMoves;
};

TEST_F(MoverFinish, VelocitiesAreOfTheOrderOfThePrediction)
{
    bench.setAssemblies(MoverBench::SUBSTEP - 2, 2);
    // (3/2 x* - 2 x + 1/2 x_)/h
    expectVelocities([&](uint32_t, const Vector3d& move, const Vector3d& last) {
        return Vector3d((1.5 * move - 0.5 * last) / h());
    });
}

TEST_F(MoverFinish, AnAssemblyTouchedInThisSubstepAnswersByFirstOrder)
{
    bench.setAssemblies(MoverBench::SUBSTEP - 1, 2);   // find_due has counted this substep already
    expectVelocities([&](uint32_t, const Vector3d& move, const Vector3d&) { return Vector3d(move / h()); });
}

TEST_F(MoverFinish, EveryParticleEndsWhereItsMoveTookIt)
{
    bench.setAssemblies(0, 1);
    bench.forMovers("body/mover_finish");
    SolverBuffers& b = bench.buffers;
    const auto centres = b.moverCentres.download(), rotations = b.moverRotations.download();
    const auto keptMoves = b.oldMoverMoves.download(), keptVelocities = b.oldMoverVelocities.download();
    for (uint32_t m = 0; m < bench.moverCount(); ++m) {
        const bool fixed = bench.isFixed(m);
        for (const Part& part : bench.parts[m]) {
            const Vector3d from = bench.centre(m) + bench.arm(m, part.r), move = bench.moveOf(m, part.r);
            const Vector3d to = vec3(centres[m]).cast<double>() + quaternion(rotations[m]).cast<double>() * part.r;
            // Half a metre, rounded a few times; the rotation is made a unit again.
            ASSERT_LT((to - (fixed ? from : Vector3d(from + move))).norm(), 5e-7) << "mover " << m;
            const Vector3d kept = bench.field(keptMoves, m).at(part.r);
            const Vector3d wanted = fixed ? bench.field(oldMoves, m).at(part.r) : move;
            ASSERT_LT((kept - wanted).norm(), 2e-8) << "mover " << m;
        }
        const Field wanted = bench.field(fixed ? oldVelocities : velocities, m);
        EXPECT_EQ(bench.field(keptVelocities, m).t, wanted.t);
        EXPECT_EQ(bench.field(keptVelocities, m).f, wanted.f);
    }
}

TEST_F(MoverFinish, DampingAndTheGreatestSpeedBoundTheVelocitiesOfAllParticles)
{
    bench.setAssemblies(0, 1);
    bench.buffers.parameters.damping = 0.5f;
    bench.buffers.parameters.maxSpeed = 1.0f;
    bench.setParameters();
    // A body is slowed as a whole, by what its farthest particle could have at most: it stays rigid.
    std::vector<double> shares;
    uint32_t slowed = 0, free = 0;
    for (uint32_t m = 0; m < bench.moverCount(); ++m) {
        const Matrix3d axes = bench.rotation(m).toRotationMatrix();
        const Matrix3d turn = quaternion(bench.turns[m]).cast<double>().toRotationMatrix() * axes - axes;
        const double most = 0.5 * (vec3(bench.moves[m]).norm() + bench.radius(m) * turn.norm()) / h();
        shares.push_back(std::min(1.0, 1.0 / most));
        (most > 1.0 ? slowed : free) += 1;
    }
    expectVelocities([&](uint32_t m, const Vector3d& move, const Vector3d&) {
        const Vector3d v = shares[m] * 0.5 * move / h();
        EXPECT_LE(v.norm(), 1.0 + 1e-6) << "mover " << m;
        return v;
    });
    EXPECT_GT(slowed, 100u);
    EXPECT_GT(free, 50u);
}

TEST_F(MoverFinish, AVelocityThatIsNotFiniteIsReportedWithAParticleOfItsMover)
{
    for (uint32_t m : {2u, bench.moverCount() - 7}) {
        const uint32_t reported = reportOf(m);
        const auto isReported = [&](const Part& part) { return part.particle == reported; };
        EXPECT_TRUE(std::any_of(bench.parts[m].begin(), bench.parts[m].end(), isReported)) << "mover " << m;
    }
}

TEST_F(MoverFinish, ABodyThatOwnsNoParticleAloneIsReportedWithOneThatItShares)
{
    const auto infos = bench.buffers.moverInfo.download();
    uint32_t crosses = 0;
    for (uint32_t m = 0; m < bench.moverCount(); ++m) {
        if (infos[m].rankCount > 0) continue;
        ++crosses;
        const uint32_t reported = reportOf(m);
        const auto isReported = [&](const Part& part) { return part.particle == reported; };
        EXPECT_TRUE(std::any_of(bench.parts[m].begin(), bench.parts[m].end(), isReported)) << "mover " << m;
    }
    EXPECT_EQ(crosses, 1u) << "the middle of the universal joint";
}

TEST_F(MoverFinish, ParticlesStandAtTheMeanOfTheirBodiesGoalsWithTheMeanOfTheirVelocities)
{
    SolverBuffers& b = bench.buffers;
    const auto before = b.positions.download(), velocitiesBefore = b.velocities.download();
    bench.forParticles("body/particle_place");
    bench.run("joint/joint_place", b.parameters.sharedCount);
    const auto after = b.positions.download(), velocitiesAfter = b.velocities.download();
    std::vector<Vector3d> places(before.size(), Vector3d::Zero()), speeds = places;
    for (uint32_t m = 0; m < bench.moverCount(); ++m) {
        for (const Part& part : bench.parts[m]) {
            const double share = 1.0 / std::max(bench.world.particles[part.particle].bodyCount, 1u);
            places[part.particle] += share * (bench.centre(m) + bench.arm(m, part.r));
            speeds[part.particle] += share * bench.field(velocities, m).at(part.r);
        }
    }
    uint32_t held = 0, heldByTwo = 0;
    for (uint32_t i = 0; i < after.size(); ++i) {
        if (bench.isFixed(bench.moverOf[i])) {
            EXPECT_EQ(vec3(after[i]), vec3(before[i])) << "particle " << i;
            EXPECT_EQ(vec3(velocitiesAfter[i]), vec3(velocitiesBefore[i])) << "particle " << i;
            ++held;
            heldByTwo += bench.world.particles[i].bodyCount > 1;
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
