#include <cmath>

#include "shared/foam_ring.h"
#include "sim/solver/solver.h"
#include "sim/solver/step.h"
#include "tests/solver/solver_test.h"

namespace knuckle::test {
namespace {

constexpr float SPACING = 0.5f * DIAMETER;

/// Water in a tank 0.6 m wide, whose walls are planes.
struct Tank {
    float height = 0.4f;         ///< Of the water [m].
    float lift = 0.0f;           ///< Of its bottom above the floor [m].
    Vector3f velocity{0, 0, 0};  ///< [m/s]
    float foam = 1.0f, viscosity = 0.001f;
    float pourHeight = 0.0f;  ///< Of a jet above the water [m]; 0: there is none.
};

World tankWorld(const Tank& tank)
{
    WorldBuilder builder(DIAMETER / 2);
    Material water;
    water.fluid = true;
    water.viscosity = tank.viscosity;
    water.look.foam = tank.foam;
    const uint32_t material = builder.addMaterial(water);
    builder.addCollider(planeAt({0, 0, 0}, {0, 1, 0}));
    for (const float side : {-1.0f, 1.0f}) {
        builder.addCollider(planeAt({0.3f * side, 0, 0}, {-side, 0, 0}));
        builder.addCollider(planeAt({0, 0, 0.3f * side}, {0, 0, -side}));
    }
    std::vector<Vector3f> places;
    const int across = static_cast<int>(std::lround(0.6f / SPACING));
    const int up = static_cast<int>(std::lround(tank.height / SPACING));
    for (int y = 0; y < up; ++y)
        for (int z = 0; z < across; ++z)
            for (int x = 0; x < across; ++x) {
                const Vector3f cell = Eigen::Vector3i(x, y, z).cast<float>();
                const Vector3f corner(-0.3f, tank.lift, -0.3f);
                places.emplace_back(corner + SPACING * (cell + Vector3f(0.5f, 0.5f, 0.5f)));
            }
    builder.addFluid(places, tank.velocity, material);
    if (tank.pourHeight == 0.0f) return builder.build();
    Emitter jet;
    jet.material = material;
    jet.pool = 600;
    jet.velocity = {0, -0.5f, 0};
    jet.nozzle = placed(discNozzle(0.1f, builder.fluidSpacing()), {0, tank.height + tank.pourHeight, 0}, {0, -1, 0});
    builder.addEmitter(jet);
    return builder.build();
}

/// The stages of a world, step by step.
class FoamRun {
public:
    explicit FoamRun(const Tank& tank) : world(tankWorld(tank)), stages(gpu(), world)
    {
        stages.load();
        Recorder recorder = stages.recorder(timer_);
        recordStart(stages, recorder);
    }
    void steps(int count)
    {
        Recorder recorder = stages.recorder(timer_);
        for (int k = 0; k < count; ++k) recordStep(stages, world.settings, recorder);
        EXPECT_EQ(stages.counters.download()[0].problems, 0u);
    }
    /// Slots of the ring that have ever had a point.
    uint32_t made() const { return stages.foam->foamRing.download()[FOAM_RING].y; }
    /// Puts one point into the ring, which is otherwise as it was.
    void put(const Vector3f& place, const Vector3f& velocity, float life)
    {
        FoamStage& foam = *stages.foam;
        const gpu::vec4 at = packed(place, 1.0f), move = packed(velocity, life);
        const gpu::uvec4 ring{1, 1, 0, 1};
        foam.foamPlaces.write(&at, sizeof at);
        foam.foamMoves.write(&move, sizeof move);
        foam.foamRing.write(&ring, sizeof ring, FOAM_RING * sizeof ring);
    }
    Vector3d place() const { return vec3(stages.foam->foamPlaces.download()[0]).cast<double>(); }
    Vector3d velocity() const { return vec3(stages.foam->foamMoves.download()[0]).cast<double>(); }
    double life() const { return stages.foam->foamMoves.download()[0].w; }
    float opacity() const { return stages.foam->foamPlaces.download()[0].w; }

    const World world;
    Stages stages;

private:
    KernelTimer timer_;
};

TEST(Foam, StillWaterMakesNone)
{
    FoamRun run({});
    run.steps(60);
    EXPECT_EQ(run.made(), 0u);
}

/// Water that goes to and fro with a tenth of its depth.
TEST(Foam, SlowWavesMakeNone)
{
    FoamRun run({.velocity = {0.3f, 0, 0}});
    run.steps(90);
    EXPECT_EQ(run.made(), 0u);
}

/// At the surface the jet is 1.5 times as fast as waves of the spacing, or 4.4 times.
TEST(Foam, WaterPouredGentlyMakesHardlyAnyAndAFallSome)
{
    FoamRun gentle({.height = 0.2f, .pourHeight = 0.06f}), fall({.height = 0.2f, .pourHeight = 0.5f});
    gentle.steps(90);
    fall.steps(90);
    EXPECT_GT(fall.made(), 100u);
    EXPECT_LT(gentle.made(), fall.made() / 10);
}

TEST(Foam, ASplashMakesSomeThatVanishesAgain)
{
    FoamRun run({.height = 0.3f, .lift = 1.2f});
    run.steps(25);
    EXPECT_LT(run.made(), 100u) << "of water that falls freely only edges do";
    run.steps(50);
    EXPECT_GT(run.made(), 500u);
    // Points of the ring are drawn, none is anywhere but above the floor and near the tank.
    const auto places = run.stages.foam->foamPlaces.download();
    uint32_t seen = 0;
    for (const gpu::vec4& p : places) {
        if (p.w <= 0.0f) continue;
        ++seen;
        EXPECT_LE(p.w, 1.0f);
        EXPECT_GT(p.y, 0.0f);
        EXPECT_LT(std::max(std::abs(p.x), std::abs(p.z)), 0.301f);
    }
    EXPECT_GT(seen, 100u);
    run.steps(6 * 60);
    for (const gpu::vec4& p : run.stages.foam->foamPlaces.download()) EXPECT_EQ(p.w, 0.0f);
}

/// v = end + exp(-t / 0.7 s) (v0 - end), end = 0.7 s g, and its integral.
TEST(Foam, SprayFliesAgainstDragOfTheAir)
{
    FoamRun run({});
    const Vector3d from(0, 5, 0), start(0.3, 2, -0.2), end(0, -9.81 * 0.7, 0);
    run.put(from.cast<float>(), start.cast<float>(), 3.0f);
    const int steps = 30;
    run.steps(steps);
    const double t = steps * double{run.world.settings.timeStep}, kept = std::exp(-t / 0.7);
    const Vector3d velocity = end + kept * (start - end), place = from + t * end + 0.7 * (1.0 - kept) * (start - end);
    EXPECT_LT((run.velocity() - velocity).norm(), 1e-4);
    EXPECT_LT((run.place() - place).norm(), 1e-4);
    EXPECT_NEAR(run.life(), 3.0 - t, 1e-4);
}

/// Falls of a tenth of the time of drag are those without it within 4 %: t / (3 * 0.7 s).
TEST(Foam, SprayFallsAtFirstAsStonesDo)
{
    FoamRun run({});
    run.put({0, 5, 0}, {0, 0, 0}, 3.0f);
    run.steps(4);
    const double t = 4 * double{run.world.settings.timeStep}, way = 0.5 * 9.81 * t * t;
    EXPECT_NEAR(5.0 - run.place().y(), way, 0.04 * way);
}

TEST(Foam, SprayLiesOnTheFloorAndVanishesSoon)
{
    FoamRun run({.height = 0.1f, .lift = 50.0f, .foam = 1e-6f});  // water that is far away and makes none
    run.put({0, 0.5f, 0}, {0, 0, 0}, 3.0f);
    run.steps(40);
    EXPECT_NEAR(run.place().y(), 0.1 * SPACING, 1e-6);
    // It falls for a third of a second, and ages four times as fast for the other third.
    EXPECT_NEAR(run.life(), 3.0 - 1.0 / 3.0 - 4.0 / 3.0, 0.1);
}

/// At half the speed of waves as long as the spacing, sqrt(g d), against the water, which rests.
TEST(Foam, BubblesRise)
{
    FoamRun run({.height = 0.5f});
    run.steps(20);
    run.put({0, 0.12f, 0}, {0, 0, 0}, 3.0f);
    run.steps(30);
    const double wanted = 0.5 * std::sqrt(9.81 * SPACING);
    EXPECT_NEAR(run.velocity().y(), wanted, 0.15 * wanted);
    // The first tenth of a second it is still getting faster.
    EXPECT_NEAR(run.place().y() - 0.12, wanted * (0.5 - 0.1), 0.2 * wanted * 0.4);
    EXPECT_FLOAT_EQ(run.opacity(), 1.0f);
    run.steps(90);
    EXPECT_LT(run.place().y(), 0.56) << "it does not leave the water";
    EXPECT_GT(run.place().y(), 0.42);
}

TEST(Foam, ChangesNothingOfTheFluid)
{
    const Tank splash{.height = 0.3f, .lift = 0.6f};
    Tank dull = splash;
    dull.foam = 0.0f;
    const World white = tankWorld(splash), clear = tankWorld(dull);
    Solver one(gpu(), white), other(gpu(), clear);
    for (int k = 0; k < 50; ++k) {
        one.step();
        other.step();
    }
    one.checkCounters(1);
    other.checkCounters(1);
    EXPECT_EQ(one.stateHash(), other.stateHash());
    EXPECT_FALSE(one.readView().foamPlaces.empty());
    EXPECT_TRUE(other.readView().foamPlaces.empty());
    EXPECT_EQ(other.view().foamCount, 0u);
}

TEST(Foam, IsOfThinFluidsOnly)
{
    EXPECT_EQ(FoamStage::capacity(tankWorld({.foam = 0.0f})), 0u);
    EXPECT_EQ(FoamStage::capacity(tankWorld({.viscosity = 0.1f})), 0u);
    EXPECT_EQ(FoamStage::capacity(tankWorld({.foam = 0.5f})), 1152u);
    EXPECT_EQ(FoamStage::capacity(tankWorld({.height = 0.1f})), 1024u) << "at least";
}

/// More than a step may make are thinned evenly, and the ring begins again at its end.
TEST(Foam, TheRingTakesNoMoreThanItMay)
{
    FoamRun run({.height = 0.3f, .lift = 1.2f, .foam = 100.0f});
    run.steps(40);
    uint32_t head = run.stages.foam->foamRing.download()[FOAM_RING].x, most = 0;
    const uint32_t room = run.stages.parameters.foamCapacity;
    for (int k = 0; k < 60; ++k) {
        run.steps(1);
        const auto ring = run.stages.foam->foamRing.download();
        EXPECT_EQ(ring[FOAM_RING].x, (head + ring[FOAM_BORN].x) % room);
        EXPECT_EQ(ring[FOAM_RING].z, head);
        most = std::max(most, ring[FOAM_BORN].x);
        head = ring[FOAM_RING].x;
    }
    EXPECT_LE(most, room / FOAM_BIRTHS_PART);
    EXPECT_GT(most, room / FOAM_BIRTHS_PART / 2);
    EXPECT_EQ(run.made(), room);
}

}  // namespace
}  // namespace knuckle::test
