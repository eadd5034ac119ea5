#include <cmath>

#include "sim/solver/layout/body_mass.h"
#include "tests/solver/body/mover_fixture.h"

namespace knuckle::test {

namespace {

/// Compares mover_predict with single particles: the field of a mover must give the result of the same formula for the
/// velocities and moves of its particles.
class MoverPredict : public testing::Test {
protected:
    explicit MoverPredict(const Settings& settings = {}) : fixture(mixedWorld(settings))
    {
        Stages& b = fixture.stages;
        velocities = fixture.randomFields(2.0f, 5.0f, 91);
        oldVelocities = fixture.randomFields(2.0f, 5.0f, 92);
        oldMoves = fixture.randomFields(0.01f, 0.02f, 93);
        impulses = fixture.randomImpulses(0.003f, 94);
        fill(b.bodies.moverVelocities, velocities);
        fill(b.bodies.oldMoverVelocities, oldVelocities);
        fill(b.bodies.oldMoverMoves, oldMoves);
        fill(b.bodies.moverImpulses, impulses);
        fixture.setMoves(0.01f, 0.05f, 3.0f);
        fixture.treatAllAsFree();
    }
    double h() const { return fixture.stages.parameters.substepTime; }
    Vector3d g() const { return vec3(fixture.stages.parameters.gravity).cast<double>(); }

    /// A particle's move by itself, and the size of its summands.
    struct Move {
        Vector3d move;
        double size;
    };
    Move predictedMove(uint32_t m, const Vector3d& r, bool second) const
    {
        const Field v = fixture.field(velocities, m), old = fixture.field(oldVelocities, m);
        const Field last = fixture.field(oldMoves, m);
        if (!second) return {h() * (v.at(r) + h() * g()), h() * (v.size(r) + h() * g().norm())};
        // x* = 4/3 x - 1/3 x_ + 8/9 h v - 2/9 h v_ + 4/9 h^2 g, as a move from x.
        return {last.at(r) / 3 + h() * (8 * v.at(r) - 2 * old.at(r) + 4 * h() * g()) / 9,
                last.size(r) / 3 + h() * (8 * v.size(r) + 2 * old.size(r) + 4 * h() * g().norm()) / 9};
    }
    /// The predicted move of a body's axes.
    Matrix3d predictedAxes(uint32_t m, bool second) const
    {
        const Matrix3d v = fixture.field(velocities, m).f, old = fixture.field(oldVelocities, m).f;
        if (!second) return h() * v;
        return fixture.field(oldMoves, m).f / 3 + h() * (8 * v - 2 * old) / 9;
    }
    void expectPrediction(uint32_t m, bool second, double rotationTolerance)
    {
        const auto predictions = fixture.stages.bodies.moverPredictions.download();
        Vector3d move = Vector3d::Zero();
        Matrix3d a = Matrix3d::Zero(), moments = Matrix3d::Zero();
        double moveSize = 0.0, matrixSize = 0.0;
        for (const Part& part : fixture.parts[m]) {
            const Move one = predictedMove(m, part.r, second);
            move += part.mass / fixture.masses[m] * one.move;
            moveSize += part.mass / fixture.masses[m] * one.size;
            a += part.mass * (fixture.arm(m, part.r) + one.move) * part.r.transpose();  // eq. 9
            matrixSize += part.mass * (part.r.norm() + one.size) * part.r.norm();
            moments += part.mass * part.r * part.r.transpose();
        }
        if (fixture.isBody(m)) {
            // Particles in a line count as thicker than their centres.
            const Matrix3d thicker = bodyMass(fixture.world, fixture.world.bodies[m]).moments - moments;
            a += (fixture.rotation(m).toRotationMatrix() + predictedAxes(m, second)) * thicker;
            moments += thicker;
        }
        // Some 16 operations, each with a rounding of at most the size of its operands.
        const Field found = fixture.field(predictions, m), impulse = fixture.field(impulses, m);
        EXPECT_LE((found.t - move).norm(), 16 * EPSILON * moveSize);
        EXPECT_LE((found.f - a).norm(), 16 * EPSILON * matrixSize);

        const gpu::vec4 moved = fixture.stages.bodies.moverMoves.download()[m];
        const Vector3d pushed = impulse.t / fixture.masses[m];
        EXPECT_LE((vec3(moved).cast<double>() - move - pushed).norm(), 16 * EPSILON * (moveSize + pushed.norm()));
        EXPECT_EQ(moved.w, 3.0f) << "what its mass is split over";
        const auto turn = quaternion(fixture.stages.bodies.moverRotationDeltas.download()[m]).cast<double>();
        EXPECT_LT(rotationError(turn * fixture.rotation(m), a + impulse.f, moments), rotationTolerance);
        EXPECT_TRUE(fixture.radius(m) > 0.0 || turn.vec() == Vector3d::Zero());
    }
    void expectPredictions(bool second)
    {
        fixture.forFreeAndLoose("body/mover_predict");
        for (uint32_t m = 0; m < fixture.moverCount(); ++m) {
            SCOPED_TRACE("mover " + std::to_string(m));
            // Single precision gives a rotation to some 1e-6, times a body's ratio of length to width.
            if (!fixture.isFixed(m)) expectPrediction(m, second, 1e-5);
        }
        const auto states = fixture.stages.particles.assemblyState.download();
        const auto infos = fixture.stages.bodies.moverInfo.download();
        for (uint32_t m = 0; m < fixture.moverCount(); ++m) {
            if (fixture.isFixed(m)) continue;
            EXPECT_EQ(states[infos[m].assembly].y, second ? 2u : 1u) << "mover " << m;
        }
    }

    MoverFixture fixture;
    std::vector<gpu::vec4> velocities, oldVelocities, oldMoves, impulses;
};

TEST_F(MoverPredict, UntouchedAssembliesMoveAsTheirParticlesWouldBySecondOrder)
{
    fixture.setAssemblies(MoverFixture::SUBSTEP - 3, 1);
    expectPredictions(true);
}

TEST_F(MoverPredict, AssembliesTouchedInTheLastSubstepMoveAsTheirParticlesWouldByFirstOrder)
{
    fixture.setAssemblies(MoverFixture::SUBSTEP - 1, 2);
    expectPredictions(false);
}

TEST_F(MoverPredict, TheFirstSubstepIsOfFirstOrder)
{
    fixture.setAssemblies(0x7fffffffu, 2);
    fixture.setCounters({});
    expectPredictions(false);
}

TEST_F(MoverPredict, SolidBodiesTurnTheSameByHouseholder)
{
    fixture.setAssemblies(MoverFixture::SUBSTEP - 1, 2);
    fixture.forFreeAndLoose("body/mover_predict", {{"HOUSEHOLDER", "1"}});
    for (uint32_t m : {0u, 1u, 2u, 3u}) expectPrediction(m, false, 1e-5);
}

TEST_F(MoverPredict, AllBodiesTurnTheSameByHigham)
{
    fixture.setAssemblies(MoverFixture::SUBSTEP - 1, 2);
    fixture.forFreeAndLoose("body/mover_predict", {{"HIGHAM", "1"}});
    for (uint32_t m = 0; m < fixture.moverCount(); ++m) {
        SCOPED_TRACE("mover " + std::to_string(m));
        if (!fixture.isFixed(m)) expectPrediction(m, false, 1e-5);
    }
}

TEST_F(MoverPredict, WhatIsFixedOrAsleepStaysAndWhatIsAnimatedIsLeftToItsAnimation)
{
    fixture.setAssemblies(MoverFixture::SUBSTEP - 3, 1);
    auto states = fixture.stages.bodies.moverStates.download();
    for (uint32_t m = 0; m < fixture.moverCount(); ++m) states[m] = m % 4;
    fill(fixture.stages.bodies.moverStates, states);
    fixture.forFreeAndLoose("body/mover_predict");
    const auto moves = fixture.stages.bodies.moverMoves.download(),
               turns = fixture.stages.bodies.moverRotationDeltas.download();
    for (uint32_t m = 0; m < fixture.moverCount(); ++m) {
        SCOPED_TRACE("mover " + std::to_string(m));
        if (states[m] == MOVER_DYNAMIC) {
            EXPECT_EQ(moves[m].w, 3.0f);
        }
        if (states[m] == MOVER_ANIMATED) {
            EXPECT_EQ(vec3(moves[m]), vec3(fixture.moves[m]));
            EXPECT_EQ(quaternion(turns[m]).coeffs(), quaternion(fixture.turns[m]).coeffs());
        }
        if (states[m] < MOVER_FIXED) continue;
        EXPECT_EQ(vec3(moves[m]), Vector3f::Zero());
        EXPECT_EQ(moves[m].w, 0.0f);
        EXPECT_EQ(quaternion(turns[m]).coeffs(), Quaternionf::Identity().coeffs());
    }
}

/// Contacts found a turn and a shift ago.
class MoverDrift : public testing::Test {
protected:
    bool isDue(uint32_t mover, const Vector3f& shift, float angle)
    {
        Stages& b = fixture.stages;
        fixture.setMoves(0.0f, 0.0f, 1.0f);
        auto centres = fixture.centres, rotations = fixture.rotations;
        for (gpu::vec4& c : centres) c.w = 0.01f;
        centres[mover] = packed(Vector3f(vec3(centres[mover]) + shift), 0.01f);
        const Quaternionf turn(Eigen::AngleAxisf(angle, Vector3f(1, 2, 2) / 3));
        rotations[mover] = packed(turn * quaternion(rotations[mover]));
        fill(b.search.searchCentres, centres);
        fill(b.search.searchRotations, rotations);
        gpu::Counters now = fixture.counters();
        now.due = 0;
        fixture.setCounters(now);
        fixture.forMovers("search/mover_drift");
        return fixture.counters().due == 1u;
    }

    MoverFixture fixture;
};

TEST_F(MoverDrift, ContactsAreDueWhenTheFarthestParticleMayHaveLeftItsMargin)
{
    const uint32_t loose = fixture.moverCount() - 1;
    for (uint32_t m : {0u, loose}) {
        EXPECT_FALSE(isDue(m, {0, 0, 0}, 0));
        EXPECT_FALSE(isDue(m, {0, 0.0099f, 0}, 0));
        EXPECT_TRUE(isDue(m, {0, 0.0101f, 0}, 0));
    }
    // A turn moves the farthest particle along a chord.
    const float angle = 2 * std::asin(0.01f / (2 * static_cast<float>(fixture.radius(0))));
    EXPECT_FALSE(isDue(0, {0, 0, 0}, 0.99f * angle));
    EXPECT_TRUE(isDue(0, {0, 0, 0}, 1.01f * angle));
    EXPECT_FALSE(isDue(0, {0.0049f, 0, 0}, 0.5f * angle));
    EXPECT_TRUE(isDue(0, {0.0051f, 0, 0}, 0.5f * angle));
    // Fixed bodies do not move.
    for (uint32_t m = 0; m < fixture.moverCount(); ++m)
        EXPECT_FALSE(fixture.isFixed(m) && isDue(m, {0, 1, 0}, 0)) << "mover " << m;
}

class MoverPredictFirst : public MoverPredict {
protected:
    static Settings settings()
    {
        Settings s;
        s.velocityOrder = VelocityOrder::First;
        return s;
    }
    MoverPredictFirst() : MoverPredict(settings()) {}
};

TEST_F(MoverPredictFirst, EverythingMovesByFirstOrderWhereChosen)
{
    fixture.setAssemblies(0, 2);
    expectPredictions(false);
}

}  // namespace

}  // namespace knuckle::test
