#include <cmath>
#include <limits>

#include "tests/solver/solver_test.h"

namespace knuckle::test {

namespace {

constexpr uint32_t SUBSTEP = 9;
/// For a movement of some centimetres: a few roundings of 2^-24.
constexpr float ROUNDING = 2e-8f;

/// The paper's predict and finish on random states of particles of every kind, in the tenth substep of a run.
class Moves : public testing::Test {
protected:
    explicit Moves(const Settings& settings = byThePaper()) : fixture(mixedWorld(settings))
    {
        const size_t count = fixture.world.particles.size();
        Stages& b = fixture.stages;
        positions = randomVectors(count, 0.5f, 61);
        velocities = randomVectors(count, 2.0f, 62);
        oldMoves = randomVectors(count, 0.01f, 63);
        oldVelocities = randomVectors(count, 2.0f, 64);
        moves = randomVectors(count, 0.01f, 65);
        fill(b.particles.positions, positions);
        fill(b.particles.velocities, velocities);
        fill(b.paper->oldMoves, oldMoves);
        fill(b.paper->oldVelocities, oldVelocities);
        fill(b.paper->predicted, moves);
        gpu::Counters now{};
        now.substep = SUBSTEP;
        fixture.setCounters(now);
    }
    bool isFixed(size_t i) const { return knuckle::isFixed(fixture.world, fixture.world.particles[i]); }
    /// Sets for all assemblies the substep of the last contact and the order.
    void setAssemblies(uint32_t lastContact, uint32_t order)
    {
        const size_t count = fixture.stages.particles.assemblyState.size();
        fill(fixture.stages.particles.assemblyState, std::vector<gpu::uvec2>(count, {lastContact, order}));
    }
    float h() const { return fixture.stages.parameters.substepTime; }
    Vector3f g() const { return vec3(fixture.stages.parameters.gravity); }
    /// Checks that every particle's predicted move is `wanted`, zero for a fixed one.
    template <typename Wanted>
    void expectMoves(Wanted wanted, uint32_t order)
    {
        fixture.forParticles("paper/predict");
        const auto found = fixture.stages.paper->predicted.download();
        const auto states = fixture.stages.particles.assemblyState.download();
        for (size_t i = 0; i < found.size(); ++i) {
            const Vector3f move = isFixed(i) ? Vector3f::Zero() : Vector3f(wanted(i));
            ASSERT_LT((vec3(found[i]) - move).norm(), ROUNDING) << "particle " << i;
        }
        const auto infos = fixture.stages.particles.particleInfo.download();
        for (size_t i = 0; i < found.size(); ++i) {
            if (isFixed(i)) continue;
            ASSERT_EQ(states[infos[i].assembly].y, order) << "particle " << i;
        }
    }
    Vector3f firstOrder(size_t i) const { return h() * (vec3(velocities[i]) + h() * g()); }
    /// Checks that every moving particle's new velocity is `wanted`; fixed ones have none.
    template <typename Wanted>
    void expectVelocities(Wanted wanted)
    {
        fixture.forParticles("paper/finish");
        const auto found = fixture.stages.particles.velocities.download();
        for (size_t i = 0; i < found.size(); ++i) {
            const Vector3f v = isFixed(i) ? Vector3f::Zero() : Vector3f(wanted(i));
            // A move's rounding over a substep of a few milliseconds.
            ASSERT_LT((vec3(found[i]) - v).norm(), ROUNDING / h()) << "particle " << i;
        }
    }

    KernelFixture fixture;
    std::vector<gpu::vec4> positions, velocities, oldMoves, oldVelocities, moves;
};

using Predict = Moves;
using Finish = Moves;

TEST_F(Predict, UntouchedAssembliesMoveBySecondOrder)
{
    setAssemblies(SUBSTEP - 3, 1);
    // x* = 4/3 x - 1/3 x_ + 8/9 h v - 2/9 h v_ + 4/9 h^2 g, as a move from x.
    expectMoves(
        [&](size_t i) {
            return Vector3f(vec3(oldMoves[i]) / 3 + h() * 8 / 9 * vec3(velocities[i]) -
                            h() * 2 / 9 * vec3(oldVelocities[i]) + 4 * h() * h() / 9 * g());
        },
        2);
}

TEST_F(Predict, AssembliesTouchedInTheLastSubstepMoveByFirstOrder)
{
    setAssemblies(SUBSTEP - 1, 2);
    expectMoves([&](size_t i) { return firstOrder(i); }, 1);
}

TEST_F(Predict, TheFirstSubstepIsOfFirstOrder)
{
    setAssemblies(0x7fffffffu, 2);
    fixture.setCounters({});
    expectMoves([&](size_t i) { return firstOrder(i); }, 1);
}

class PredictFirstOrder : public Moves {
protected:
    PredictFirstOrder() : Moves(paperSettings()) {}
};

TEST_F(PredictFirstOrder, EverythingMovesByFirstOrderWhereChosen)
{
    setAssemblies(0, 2);
    expectMoves([&](size_t i) { return firstOrder(i); }, 1);
}

TEST_F(PredictFirstOrder, ContactsSeeTheLowerParticlesHeavier)
{
    fixture.stages.parameters.massScaling = 1.5f;
    fixture.setParameters();
    fixture.forParticles("paper/predict", {{"MASS_SCALING", "1"}});
    const auto predicted = fixture.stages.paper->predicted.download();
    for (size_t i = 0; i < predicted.size(); ++i) {
        // m exp(-k height) (Macklin et al. 2014, 5.2); a few roundings, and those of an exponent below 1.
        const double mass = double(fixture.world.particles[i].mass) * std::exp(-1.5 * double(positions[i].y));
        ASSERT_NEAR(double(predicted[i].w) * mass, isFixed(i) ? 0.0 : 1.0, 2e-6) << "particle " << i;
    }
}

TEST_F(PredictFirstOrder, ASearchIsDueWhereSomebodyWouldLeaveItsMargin)
{
    setAssemblies(0, 2);
    fixture.forParticles("paper/predict");
    const auto predicted = fixture.stages.paper->predicted.download();
    const float drift = fixture.stages.parameters.drift;
    EXPECT_FLOAT_EQ(drift, 0.05f * DIAMETER) << "a quarter of the margin between two, half of one's own";
    for (float far : {0.99f, 1.01f}) {
        // All but one at their searched places; that one next to its place.
        std::vector<gpu::vec4> found;
        for (size_t i = 0; i < positions.size(); ++i) found.push_back(packed(vec3(positions[i]) + vec3(predicted[i])));
        const size_t mover = positions.size() / 2;
        found[mover] = packed(vec3(found[mover]) + far * drift * Vector3f(0.6f, 0.0f, -0.8f));
        fill(fixture.stages.search.searchPositions, found);
        gpu::Counters now = fixture.counters();
        now.due = 0;
        fixture.setCounters(now);
        fixture.forParticles("paper/predict");
        EXPECT_EQ(fixture.counters().due, far > 1.0f ? 1u : 0u) << far;
    }
}

TEST_F(Finish, VelocitiesAreOfTheOrderOfThePrediction)
{
    setAssemblies(SUBSTEP - 2, 2);
    // (3/2 x* - 2 x + 1/2 x_)/h
    expectVelocities([&](size_t i) { return Vector3f((1.5f * vec3(moves[i]) - 0.5f * vec3(oldMoves[i])) / h()); });
    const auto kept = fixture.stages.paper->oldMoves.download();
    const auto keptVelocities = fixture.stages.paper->oldVelocities.download();
    for (size_t i = 0; i < kept.size(); ++i) {
        EXPECT_EQ(vec3(kept[i]), isFixed(i) ? Vector3f::Zero() : vec3(moves[i]));
        EXPECT_EQ(vec3(keptVelocities[i]), vec3(velocities[i]));
    }
}

TEST_F(Finish, AnAssemblyTouchedInThisSubstepAnswersByFirstOrder)
{
    setAssemblies(SUBSTEP - 1, 2);  // search_due has counted this substep already
    expectVelocities([&](size_t i) { return Vector3f(vec3(moves[i]) / h()); });
}

TEST_F(Finish, DampingAndTheGreatestSpeedBoundVelocities)
{
    setAssemblies(0, 1);
    fixture.stages.parameters.damping = 0.5f;
    fixture.stages.parameters.maxSpeed = 1.0f;
    fixture.setParameters();
    expectVelocities([&](size_t i) {
        const Vector3f v = 0.5f * vec3(moves[i]) / h();
        return Vector3f(v * std::min(1.0f, 1.0f / v.norm()));
    });
}

TEST_F(Finish, ParticlesOfBodiesStandWhereTheyPutThemAndOthersMove)
{
    setAssemblies(0, 1);
    Random random(66);
    std::vector<gpu::vec4> centres, rotations;
    for (uint32_t m = 0; m < fixture.stages.parameters.moverCount; ++m) {
        centres.push_back(packed(random.inCube(0.5f)));
        rotations.push_back(packed(random.rotation()));
    }
    fill(fixture.stages.bodies.moverCentres, centres);
    fill(fixture.stages.bodies.moverRotations, rotations);
    fixture.forParticles("paper/finish");
    const auto found = fixture.stages.particles.positions.download();
    // A shared particle is at the mean of where its bodies have it.
    std::vector<Vector3d> goals(found.size(), Vector3d::Zero());
    for (const Link& link : fixture.world.links) {
        const Vector3f place = vec3(centres[link.body]) + quaternion(rotations[link.body]) * link.restOffset;
        goals[link.particle] += place.cast<double>() / fixture.world.particles[link.particle].bodyCount;
    }
    for (size_t i = 0; i < found.size(); ++i) {
        const Particle& p = fixture.world.particles[i];
        Vector3f wanted = vec3(positions[i]);
        if (!isFixed(i) && p.bodyCount > 0) wanted = goals[i].cast<float>();
        else if (!isFixed(i)) wanted += vec3(moves[i]);
        // Half a metre, rounded a few times.
        ASSERT_LT((vec3(found[i]) - wanted).norm(), 5e-7f) << "particle " << i;
    }
}

class FinishFrozen : public Moves {
protected:
    FinishFrozen() : Moves(freezing()) {}
    static Settings freezing()
    {
        Settings settings = byThePaper();
        settings.freeze = 0.5f;
        return settings;
    }
};

TEST_F(FinishFrozen, WhatIsFrozenKeepsItsPlaceAndHasNoSpeed)
{
    setAssemblies(0, 1);
    // Every second assembly.
    auto states = fixture.stages.bodies.moverStates.download();
    const auto movers = fixture.stages.bodies.moverInfo.download();
    for (size_t m = 0; m < states.size(); ++m)
        if (movers[m].assembly % 2 == 0 && states[m] == MOVER_DYNAMIC) states[m] = MOVER_ASLEEP;
    fill(fixture.stages.bodies.moverStates, states);
    fixture.forParticles("paper/finish");
    const auto places = fixture.stages.particles.positions.download(),
               found = fixture.stages.particles.velocities.download();
    const auto infos = fixture.stages.particles.particleInfo.download();
    uint32_t frozen = 0;
    for (size_t i = 0; i < found.size(); ++i) {
        if (isFixed(i)) continue;
        const bool still = infos[i].assembly % 2 == 0;
        frozen += still;
        EXPECT_EQ(vec3(found[i]).norm() == 0.0f, still) << "particle " << i;
        EXPECT_EQ(vec3(places[i]) == vec3(positions[i]), still) << "particle " << i;
    }
    EXPECT_GT(frozen, 100u);
}

TEST_F(Finish, AVelocityThatIsNotFiniteIsReportedWithItsParticle)
{
    setAssemblies(0, 1);
    auto bad = moves;
    bad[777].y = std::numeric_limits<float>::quiet_NaN();
    fill(fixture.stages.paper->predicted, bad);
    fixture.forParticles("paper/finish");
    EXPECT_EQ(fixture.counters().problems, PROBLEM_NAN);
    EXPECT_EQ(fixture.counters().badParticle, 777u);
}

}  // namespace

}  // namespace knuckle::test
