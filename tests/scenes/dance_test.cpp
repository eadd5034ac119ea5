#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sim/solver/measure/state.h"
#include "tests/places.h"
#include "tests/scenes/scene_watch.h"
#include "tests/temp_folder.h"

namespace knuckle::test {

namespace {

constexpr double SECOND = 480;  ///< Steps, with one substep each.

/// The figure alone, without gravity, let go at a time of its dance.
Scene letGoAt(double time)
{
    const TempFolder folder;
    const std::string file = inSource("assets/models/humanoid.glb");
    return loadScene(folder.write("scene.json", R"({"duration": 8, "fps": 480, "diameter": 0.04,
        "solver": {"gravity": [0, 0, 0], "substeps": 1}, "objects": [{"type": "actor", "file": ")" +
                                                    file +
                                                    R"(", "animation": {"clip": "dance"}, "release": {"clipTime": )" +
                                                    std::to_string(time) + "}}]}"));
}

/// Of all bodies.
struct Momentum {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double size = 0.0;  ///< Sum of m |v|.
};

Momentum momentumOf(const World& world, const std::vector<BodyState>& bodies)
{
    Momentum all;
    for (size_t b = 0; b < bodies.size(); ++b) {
        const Eigen::Vector3d v = bodies[b].velocity.cast<double>();
        all.sum += world.bodies[b].mass * v;
        all.size += world.bodies[b].mass * v.norm();
    }
    return all;
}

}  // namespace

/// Ten moments of steps, turn and leap.
TEST(Dance, WhatIsLetGoMovesOnAsItDanced)
{
    int untouched = 0;
    for (const double time : {0.4, 1.1, 1.7, 2.3, 2.9, 3.6, 4.9, 5.2, 5.5, 7.2}) {
        const Scene scene = letGoAt(time);
        Solver solver(gpu(), scene.world);
        const auto before = static_cast<int>(std::ceil(time * SECOND - 1e-3));
        for (int i = 0; i < before; ++i) solver.step();
        const std::vector<BodyState> told = solver.readBodies();
        solver.step();
        const std::vector<BodyState> free = solver.readBodies();
        const Momentum was = momentumOf(scene.world, told), is = momentumOf(scene.world, free);
        // Measured 1e-6, and 0.4 % if limbs touch, which ends second order: a speed is then that of half a step ago.
        EXPECT_LT((is.sum - was.sum).norm(), 0.01 * was.size) << "at " << time;
        float fastest = 0.0f, change = 0.0f;
        for (size_t b = 0; b < told.size(); ++b) {
            fastest = std::max(fastest, told[b].velocity.norm());
            change = std::max(change, (free[b].velocity - told[b].velocity).norm());
        }
        // Measured 1.5 % at most. Limbs that overlap in the clip are pushed out.
        if (solver.measure().contactCount == 0) {
            EXPECT_LT(change, 0.02f * fastest) << "at " << time;
            ++untouched;
        }
        float gap = 0.0f;
        for (int i = 0; i < 100; ++i) {
            solver.step();
            gap = std::max(gap, solver.measure().worstJointGap / scene.world.diameter());
        }
        EXPECT_LT(gap, 2e-3f) << "at " << time;  // measured 2e-4
    }
    EXPECT_GE(untouched, 8);
}

/// Until its leap the dancer is at its clip's place, whatever it meets; then it lies on the ground, among crates that
/// it has knocked over.
TEST(Dance, TheDancerKnocksOverCratesAndCollapses)
{
    const Scene scene = sceneOf("dance", {});
    const World& world = scene.world;
    Solver solver(gpu(), world);
    const uint32_t dancer = world.animations[0].object, end = world.objects[dancer].bodyCount;
    ASSERT_EQ(dancer, 0u);
    const auto steps = static_cast<int>(5.25 / world.settings.timeStep);
    for (int i = 0; i < steps; ++i) solver.step();
    solver.checkCounters(0);
    const std::vector<Pose> wanted = bodyPlaces(world, world.animations[0], steps * double{world.settings.timeStep});
    std::vector<BodyState> bodies = solver.readBodies();
    for (uint32_t b = 0; b < end; ++b)
        EXPECT_LT((bodies[b].position - wanted[b].translation).norm(), 1e-4f) << world.bodies[b].name;
    uint32_t fallen = 0;
    for (size_t b = end; b < bodies.size(); ++b) fallen += bodies[b].position.y() < world.bodies[b].position.y() - 0.2f;
    EXPECT_GE(fallen, 4u);
    const Watched fall = watch(solver, scene, 1.8, 0);
    EXPECT_LT(fall.gap, 0.05f);
    EXPECT_LT(fall.low, 0.5f);
    bodies = solver.readBodies();
    // A hand may lie on a crate.
    for (uint32_t b = 0; b < end; ++b) EXPECT_LT(bodies[b].position.y(), 1.0f) << world.bodies[b].name;
    EXPECT_LT(bodies[0].position.y(), 0.5f) << "hips";
}

}  // namespace knuckle::test
