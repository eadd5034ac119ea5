#include <gtest/gtest.h>

#include <algorithm>

#include "tests/scenes/scene_watch.h"

namespace knuckle::test {

namespace {

float highest(Solver& solver, uint32_t first, uint32_t count)
{
    float high = 0.0f;
    const std::vector<BodyState> bodies = solver.readBodies();
    for (uint32_t b = first; b < first + count; ++b) high = std::max(high, bodies[b].position.y());
    return high;
}

}  // namespace

/// First on the landing, 0.9 m high, then at the foot of the stairs.
TEST(CreatureScenes, TheDogFallsDownTheStairs)
{
    const Scene scene = sceneOf("dog", {"diameter=0.04"});
    const Object& dog = scene.world.objects[0];
    Solver solver(gpu(), scene.world);
    watch(solver, scene, 1.3, 0);
    EXPECT_GT(highest(solver, dog.bodyStart, dog.bodyCount), 1.4f);
    const Watched fall = watch(solver, scene, 1.7, 0);
    EXPECT_LT(fall.gap, 0.05f);
    EXPECT_LT(highest(solver, dog.bodyStart, dog.bodyCount), 0.75f);
}

/// Crates do not let go of it; the ball does, at 3.7 s.
TEST(CreatureScenes, TheSpiderFallsWhereTheBallStrikesIt)
{
    const Scene scene = sceneOf("spider", {"diameter=0.05", "objects.1.position=[-4,0.12,-4]"});  // no crates
    const Object& spider = scene.world.objects[0];
    Solver solver(gpu(), scene.world);
    const auto trunk = [&] { return solver.readBodies()[spider.bodyStart].position; };
    watch(solver, scene, 3.5, 0);
    EXPECT_GT(trunk().y(), 0.29f);
    const Watched fall = watch(solver, scene, 1.5, 0);
    EXPECT_LT(fall.gap, 0.05f);
    EXPECT_LT(trunk().y(), 0.25f);
}

}  // namespace knuckle::test
