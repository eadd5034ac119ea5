#include <gtest/gtest.h>

#include "tests/scenes/scene_watch.h"

namespace knuckle::test {

namespace {

constexpr double RELEASE = 2.7;  ///< Of the first dancer [s].

void runSteps(Solver& solver, int count)
{
    for (int i = 1; i <= count; ++i) {
        solver.step();
        solver.checkCounters(static_cast<uint64_t>(i));
    }
}

}  // namespace

/// Nine of the dancers. Halfway through the wave the last one is still at its clip's place, and the first one falls; at
/// the end all lie.
TEST(Troupe, AWaveGoesThroughTheDancers)
{
    const Scene scene = sceneOf("troupe", {"objects.0.repeat.counts=[3,1,3]"});
    const World& world = scene.world;
    ASSERT_EQ(world.animations.size(), 9u);
    for (size_t copy = 0; copy < 9; ++copy)
        EXPECT_NEAR(world.bodies[world.objects[copy].bodyStart].releaseTime,
                    RELEASE + 0.14 * static_cast<double>(copy % 3 + copy / 3), 1e-5)
            << "copy " << copy;
    Solver solver(gpu(), world);
    const int steps = 183;
    runSteps(solver, steps);
    const auto awayFromClip = [&](size_t copy) {
        const Pose wanted = bodyPlaces(world, world.animations[copy], steps * double{world.settings.timeStep})[0];
        const BodyState hips = solver.readBodies()[world.objects[copy].bodyStart];
        return (hips.position - wanted.translation).norm();
    };
    EXPECT_LT(awayFromClip(8), 1e-4f);
    EXPECT_LT(awayFromClip(7), 1e-4f);
    EXPECT_GT(awayFromClip(0), 0.02f) << "its clip lands on its feet";
    const Watched fall = watch(solver, scene, 2.5, 0);
    EXPECT_LT(fall.gap, 0.05f);
    EXPECT_LT(fall.low, 1.0f);  // of a hand that strikes the ground; measured 0.6 and 0.8
    for (const BodyState& body : solver.readBodies()) EXPECT_LT(body.position.y(), 0.6f);
}

/// The water ahead of the walker is higher than at rest, that behind it lower; then the walker falls in.
TEST(Wade, TheWalkerPushesAWaveAndFallsIn)
{
    const Scene scene = sceneOf("wade", {"diameter=0.09"});
    const World& world = scene.world;
    Solver solver(gpu(), world);
    runSteps(solver, 96);
    const float front = solver.readBodies()[0].position.x();
    const ParticleState state = solver.readParticles();
    // The level is twice the mean height of the water in a stretch of the pool.
    const auto levelIn = [&](float from, float to) {
        double sum = 0.0, count = 0.0;
        for (size_t i = 0; i < world.particles.size(); ++i) {
            const Vector3f& p = state.positions[i];
            if (world.particles[i].body != NO_INDEX || p.x() < from || p.x() > to) continue;
            sum += 2.0 * p.y();
            count += 1.0;
        }
        return sum / count;
    };
    const double ahead = levelIn(front + 0.1f, front + 0.5f), behind = levelIn(front - 0.6f, front - 0.2f);
    std::printf("level ahead %.3f, behind %.3f of %.3f m\n", ahead, behind, levelIn(-2, 2));
    EXPECT_GT(ahead - behind, 0.03);
    runSteps(solver, 72);
    const Measures fallen = solver.measure();
    EXPECT_LT(fallen.worstJointGap, 0.05f * world.diameter());
    EXPECT_LT(fallen.meanDensityError, 0.05f);
    for (const BodyState& body : solver.readBodies()) EXPECT_LT(body.position.y(), 0.75f);
}

}  // namespace knuckle::test
