#include <gtest/gtest.h>

#include "tests/scenes/scene_watch.h"

namespace knuckle::test {

namespace {

/// One line per measure, so that a failure shows all of them.
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

/// 96 of the pairs, in a box that is smaller accordingly.
TEST(Scenes, PileComesToRestInItsBox)
{
    const Scene scene = sceneOf(
        "pile", {"objects.0.repeat.counts=[3,8,4]", "colliders.0.width=2.44", "colliders.0.depth=1.72"});
    Solver solver(gpu(), scene.world);
    // Measured: 1.03e-4, 0.126, 0.040, 2.0e-6, 4.5 m/s, 0.023, 1.13 m; the walls are at 1.22 m.
    Watched falling{.gap = 2.1e-4f,
                    .penetration = 0.25f,
                    .meanPenetration = 0.08f,
                    .shapeError = 4e-6f,
                    .speed = 9,
                    .rise = 0.046f,
                    .far = 1.22f};
    expectWithin(watch(solver, scene, 3, 0), falling);
    // Measured: 4.8e-6, 0.020, 0.0034, 2.0e-6, 0.27 m/s, 3.6e-4, and 0.051 m/s on the mean.
    Watched resting{.gap = 1e-5f,
                    .penetration = 0.04f,
                    .meanPenetration = 0.007f,
                    .shapeError = 4e-6f,
                    .speed = 0.55f,
                    .rise = 7e-4f,
                    .far = 1.22f};
    expectWithin(watch(solver, scene, 2, 0), resting);
    EXPECT_LT(meanSpeed(scene, solver), 0.1);
}

/// Four of the twelve.
TEST(Scenes, RagdollsComeToRestOnTheGround)
{
    const Scene scene = sceneOf("ragdolls", {"objects.0.repeat.counts=[2,2,1]"});
    Solver solver(gpu(), scene.world);
    // Measured: 0.061, 0.51, 0.23, 3.8e-6, 10.6 m/s (the end of a limb, which strikes the ground), no rise except
    // rounding (2e-6), 0.006, 1.64 m.
    Watched falling{.gap = 0.12f,
                    .penetration = 1,
                    .meanPenetration = 0.46f,
                    .shapeError = 8e-6f,
                    .speed = 21,
                    .rise = 1e-5f,
                    .low = 0.012f,
                    .far = 3.3f};
    expectWithin(watch(solver, scene, 3, 0), falling);
    // Measured: 5.4e-6, 0.0053, 7.7e-4, 2.8e-6, 0.64 m/s (a limb), 3.6e-5, and 0.013 m/s on the mean.
    Watched resting{.gap = 1.1e-5f,
                    .penetration = 0.011f,
                    .meanPenetration = 0.0016f,
                    .shapeError = 6e-6f,
                    .speed = 1.3f,
                    .rise = 8e-5f,
                    .far = 3.3f};
    expectWithin(watch(solver, scene, 2, 0), resting);
    EXPECT_LT(meanSpeed(scene, solver), 0.027);
}

TEST(Scenes, TerrainIsPassedAndNothingFallsThroughIt)
{
    const Scene scene = sceneOf("terrain", {});
    Solver solver(gpu(), scene.world);
    // Measured: 0.0017, 0.22, 0.067, 1.6e-5 (far away places are rounded more), 12.1 m/s, no rise but of rounding
    // (4e-7; of the same with 5 to 16 substeps and other places of the balls, 50 runs, 0.004), 23 m.
    Watched bounds{.gap = 0.0034f,
                   .penetration = 0.44f,
                   .meanPenetration = 0.14f,
                   .shapeError = 3e-5f,
                   .speed = 24,
                   .rise = 0.008f,
                   .far = 47};
    expectWithin(watch(solver, scene, 6, -2.6f), bounds);
}

/// A third of the water.
TEST(Scenes, PotpourriStaysInItsBasin)
{
    const Scene scene = sceneOf("potpourri", {"objects.0.size=[1.9,0.16,2]", "objects.0.position=[-0.85,0.08,0]"});
    Solver solver(gpu(), scene.world);
    // Measured: 6.6e-4, 0.69, 0.044, 2.2e-6, 8.8 m/s, 0.012, 1.788 m (the walls are at 1.85), 9.1e-4, 0.64, 0.036
    // when it splashes.
    Watched falling{.gap = 1.3e-3f,
                    .penetration = 1.4f,
                    .meanPenetration = 0.09f,
                    .shapeError = 5e-6f,
                    .speed = 18,
                    .rise = 0.024f,
                    .far = 1.85f,
                    .stretch = 0.0018f,
                    .strain = 1.3f,
                    .densityError = 0.045f};
    expectWithin(watch(solver, scene, 2, 0), falling);
    // Measured: 3.3e-6, 0.13 (0.6 where the splash has caught one thing under another), 0.0016, 2.0e-6, 3.4 m/s (a
    // drop), 0.013 (what drops do differs from driver to driver), 7.8e-5, 0.12, 0.0204; 0.51 m/s on the mean.
    Watched sloshing{.gap = 7e-6f,
                     .penetration = 1.2f,
                     .meanPenetration = 0.0031f,
                     .shapeError = 4e-6f,
                     .speed = 7,
                     .rise = 0.0125f,
                     .far = 1.85f,
                     .stretch = 1.6e-4f,
                     .strain = 0.24f,
                     .densityError = 0.03f};
    expectWithin(watch(solver, scene, 2, 0), sloshing);
    EXPECT_LT(meanSpeed(scene, solver), 1.03);
}

}  // namespace

}  // namespace knuckle::test
