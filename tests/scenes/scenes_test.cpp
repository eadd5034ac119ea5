#include <gtest/gtest.h>

#include "tests/scenes/scene_watch.h"

namespace knuckle::test {

namespace {

/// One line a measure, so that a failure says all of them.
void expectWithin(const Watched& found, const Watched& bounds)
{
    EXPECT_LE(found.gap, bounds.gap) << "diameters, joints";
    EXPECT_LE(found.penetration, bounds.penetration) << "diameters, the deepest contact";
    EXPECT_LE(found.meanPenetration, bounds.meanPenetration) << "diameters, contacts on the mean";
    EXPECT_LE(found.shapeError, bounds.shapeError) << "diameters, bodies are not rigid";
    EXPECT_LE(found.speed, bounds.speed) << "m/s";
    EXPECT_LE(found.rise, bounds.rise) << "of the energy at the start";
    EXPECT_LE(found.low, bounds.low) << "diameters below the floor";
    EXPECT_LE(found.far, bounds.far) << "m from the middle";
    EXPECT_LE(found.stretch, bounds.stretch) << "ropes and cloth";
    EXPECT_LE(found.strain, bounds.strain) << "soft bodies";
    EXPECT_LE(found.densityError, bounds.densityError) << "fluids";
}

/// 96 of the pairs, in a box as much smaller.
TEST(Scenes, PileComesToRestInItsBox)
{
    const Scene scene = sceneOf(
        "pile", {"objects.0.repeat.counts=[3,8,4]", "colliders.0.width=2.44", "colliders.0.depth=1.72"});
    Solver solver(gpu(), scene.world);
    // Measured: 9e-5, 0.12, 0.05, 2e-6, 4.5 m/s, 0.034, 1.16 m.
    Watched falling{.gap = 5e-4f,
                    .penetration = 0.4f,
                    .meanPenetration = 0.15f,
                    .shapeError = 1e-5f,
                    .speed = 12,
                    .rise = 0.1f,
                    .far = 1.22f};
    expectWithin(watch(solver, scene, 3, 0), falling);
    // Measured: 5e-6, 0.02, 0.004, 0.15 m/s, 5e-4, and 0.012 m/s on the mean.
    Watched resting{.gap = 3e-5f,
                    .penetration = 0.1f,
                    .meanPenetration = 0.02f,
                    .shapeError = 1e-5f,
                    .speed = 0.6f,
                    .rise = 2e-3f,
                    .far = 1.22f};
    expectWithin(watch(solver, scene, 2, 0), resting);
    EXPECT_LT(meanSpeed(scene, solver), 0.06);
}

/// Four of the twelve.
TEST(Scenes, RagdollsComeToRestOnTheGround)
{
    const Scene scene = sceneOf("ragdolls", {"objects.0.repeat.counts=[2,2,1]"});
    Solver solver(gpu(), scene.world);
    // Measured: 0.063 (0.016 of most), 0.62, 0.18, 4e-6, 15.8 m/s (the end of a limb, which strikes the ground), 4e-4,
    // 1.8 m.
    Watched falling{.gap = 0.1f,
                    .penetration = 0.9f,
                    .meanPenetration = 0.5f,
                    .shapeError = 2e-5f,
                    .speed = 40,
                    .rise = 4e-3f,
                    .low = 0.4f,
                    .far = 4};
    expectWithin(watch(solver, scene, 3, 0), falling);
    // Measured: 7e-6, 0.05, 0.004, 0.9 m/s (a thigh that does not come to rest), 0.02, and 0.08 m/s on the mean.
    Watched resting{.gap = 5e-5f,
                    .penetration = 0.2f,
                    .meanPenetration = 0.02f,
                    .shapeError = 2e-5f,
                    .speed = 3,
                    .rise = 0.1f,
                    .far = 4};
    expectWithin(watch(solver, scene, 2, 0), resting);
    EXPECT_LT(meanSpeed(scene, solver), 0.25);
}

TEST(Scenes, TerrainIsPassedAndNothingFallsThroughIt)
{
    const Scene scene = sceneOf("terrain", {});
    Solver solver(gpu(), scene.world);
    // Measured: 0.002, 0.29, 0.044, 2e-5 (far away places are rounded more), 14.7 m/s, 28 m. The energy rises by 0.06,
    // as it should not: balls that jam between the figure and the hill begin to spin and are thrown out.
    Watched bounds{.gap = 0.01f,
                   .penetration = 0.9f,
                   .meanPenetration = 0.2f,
                   .shapeError = 1e-4f,
                   .speed = 40,
                   .rise = 0.3f,
                   .far = 80};
    expectWithin(watch(solver, scene, 6, -2.6f), bounds);
}

/// A third of the water.
TEST(Scenes, PotpourriStaysInItsBasin)
{
    const Scene scene = sceneOf("potpourri", {"objects.0.size=[1.9,0.16,2]", "objects.0.position=[-0.85,0.08,0]"});
    Solver solver(gpu(), scene.world);
    // Measured: 5e-4, 0.92, 0.044, 2e-6, 12.6 m/s, 0.008, 1.79 m, 0.0016, 0.66, 0.003; 0.008 of a limb that strikes
    // the ground.
    Watched falling{.gap = 3e-3f,
                    .penetration = 1.8f,
                    .meanPenetration = 0.2f,
                    .shapeError = 1e-5f,
                    .speed = 40,
                    .rise = 0.05f,
                    .low = 0.05f,
                    .far = 1.85f,
                    .stretch = 0.01f,
                    .strain = 2,
                    .densityError = 0.02f};
    expectWithin(watch(solver, scene, 2, 0), falling);
    // Measured: 4e-6, 0.26 (a limb is jammed at its limits; in another run 0.04), 0.0014, 4.5 m/s (a drop), 0.01, 6e-5,
    // 0.15, 0.0012; 0.4 m/s on the mean.
    Watched sloshing{.gap = 3e-5f,
                     .penetration = 0.5f,
                     .meanPenetration = 0.01f,
                     .shapeError = 1e-5f,
                     .speed = 15,
                     .rise = 0.05f,
                     .far = 1.85f,
                     .stretch = 5e-4f,
                     .strain = 0.6f,
                     .densityError = 0.01f};
    expectWithin(watch(solver, scene, 2, 0), sloshing);
    EXPECT_LT(meanSpeed(scene, solver), 1.2);
}

}  // namespace

}  // namespace knuckle::test
