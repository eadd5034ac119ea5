#include <algorithm>
#include <cmath>

#include "sim/solver/measure/measure.h"
#include "tests/physics/fluid/tank.h"

namespace knuckle::test {

namespace {

TEST(Fluid, WaterAtRestKeepsItsDensityAndVolumeAndIsQuiet)
{
    Tank tank(13, 13, 11);
    const World world = tank.builder.build();
    Solver solver(gpu(), world);
    run(solver, world, 3.0);
    const ParticleState state = solver.readParticles();
    // The mean height of a fluid that fills a tank to H is H/2; 13 layers of 0.05 m.
    EXPECT_NEAR(2.0 * meanHeight(world, state, tank.fluids[0]), 0.65, 0.02 * 0.65);
    EXPECT_LT(solver.measure().meanDensityError, 0.01f);
    // Weight gives a particle gravity times a substep, 0.02 m/s, which pressures take back.
    EXPECT_LT(rootMeanSquareSpeed(state), 0.05);
}

/// A tank with a cube of `edge` particles in its middle, its centre at a height [m].
World withCube(Tank&& tank, int edge, float density, float height)
{
    Material material;
    material.density = density;
    const uint32_t light = tank.builder.addMaterial(material);
    tank.builder.beginObject("cube");
    tank.builder.addBody("cube", boxLattice(Eigen::Vector3i::Constant(edge), DIAMETER), light);
    tank.builder.endObject({Vector3f(0.5f * tank.width, height, 0.5f * tank.depth)});
    return tank.builder.build();
}

TEST(Fluid, ABodyFloatsAsDeepAsItIsDense)
{
    for (float density : {300.0f, 600.0f}) {
        const float edge = 4 * DIAMETER;
        const World world = withCube({20, 11, 20}, 4, density, 0.55f + edge * (0.5f - 0.0008f * density));
        Solver solver(gpu(), world);
        run(solver, world, 3.0);
        const BodyState cube = solver.readBodies()[0];
        EXPECT_NEAR(submergedIn(world, cube, Vector3f::Constant(edge), std::pow(20 * world.fluidSpacing, 2)),
                    density / 1000.0, 0.05)
            << "density " << density;
    }
}

TEST(Fluid, IceRisesThroughWater)
{
    const World world = withCube({18, 16, 18}, 3, 900.0f, 0.3f);
    Solver solver(gpu(), world);
    const Vector3f start = solver.readBodies()[0].position;
    run(solver, world, 1.0);
    const Vector3f way = solver.readBodies()[0].position - start;
    // With the drag of a cube (1.05) and an added mass of 0.67 of what it displaces: v / g' ln cosh(g' t / v) = 0.26 m,
    // the terminal speed v = 0.75 m/s, g' = 0.62 m/s2. Walls, floor and surface are near: 15 %.
    EXPECT_NEAR(way.y(), 0.26, 0.15 * 0.26);
    EXPECT_LT(way.head<1>().norm() + way.tail<1>().norm(), 0.1f);
}

/// A cube that lies on the floor leaves it as if there were water below it, or stays.
TEST(Fluid, WhatLiesOnTheFloorRisesIfItIsLighter)
{
    for (const float density : {900.0f, 1060.0f}) {
        const float start = 1.5f * DIAMETER;
        const World world = withCube({14, 10, 14}, 3, density, start);
        Solver solver(gpu(), world);
        float highest = 0.0f, fastest = 0.0f;
        for (int k = 0; k < 15; ++k) {
            run(solver, world, 0.1);
            const BodyState cube = solver.readBodies()[0];
            highest = std::max(highest, cube.position.y() - start);
            fastest = std::max(fastest, cube.velocity.y());
        }
        // Without drag, and with an added mass of 0.67 of what it displaces, what is lighter moves at a t.
        const double most = GRAVITY * (1000 - density) / (density + 670) * 1.5f;
        if (density < 1000) {
            EXPECT_GT(highest, 0.15f) << density;
            EXPECT_LT(fastest, most) << density;
        } else {
            EXPECT_LT(highest, 0.002f) << density;
        }
    }
}

TEST(Fluid, ThinAndSmallBodiesFloatAsDeepAsTheyAreDense)
{
    struct Case {
        Eigen::Vector3i counts;
        float density, start;  // start: height of the middle [m]
    };
    // A plate as thin as a particle, a small cube let go below the surface, a post that has to lie down.
    for (const auto& [counts, density, start] :
         {Case{{3, 1, 3}, 500, 0.4f}, Case{{3, 3, 3}, 700, 0.2f}, Case{{2, 4, 2}, 400, 0.45f}}) {
        Tank tank(14, 8, 14);
        Material light;
        light.density = density;
        const uint32_t material = tank.builder.addMaterial(light);
        tank.builder.beginObject("box");
        tank.builder.addBody("box", boxLattice(counts, DIAMETER), material);
        tank.builder.endObject({Vector3f(0.5f * tank.width, start, 0.5f * tank.depth)});
        const World world = tank.builder.build();
        Solver solver(gpu(), world);
        run(solver, world, 3.0);
        double sum = 0.0;  // averaged over three seconds: small bodies bob
        for (int k = 0; k < 30; ++k) {
            run(solver, world, 0.1);
            sum += submergedIn(world, solver.readBodies()[0], DIAMETER * counts.cast<float>(), tank.width * tank.depth);
        }
        EXPECT_NEAR(sum / 30, density / 1000.0, 0.08) << counts.transpose() << " particles of " << density;
    }
}

TEST(Fluid, TheLighterOfTwoRises)
{
    // The lighter fluid starts below, with everything at rest: nothing happens for a second.
    Tank tank(9, 12, 9, {600.0f, 1000.0f});
    const World world = tank.builder.build();
    Solver solver(gpu(), world);
    run(solver, world, 7.0);
    const ParticleState state = solver.readParticles();
    // When separated, their mean heights would differ by half of the 0.6 m; drops of each stay in the other for long.
    EXPECT_GT(meanHeight(world, state, tank.fluids[0]) - meanHeight(world, state, tank.fluids[1]), 0.15);
}

TEST(Fluid, FloorsThatCoincideAreOne)
{
    double heights[3];
    for (int more = 0; more < 3; ++more) {
        Tank tank(8, 8, 8);
        // One at the same place, or one 2 mm below it, as floors for drawing are placed.
        for (int k = 0; k < more; ++k)
            addPlane(tank.builder, {0, -0.002f * static_cast<float>(k), 0}, Vector3f::UnitY());
        const World world = tank.builder.build();
        Solver solver(gpu(), world);
        run(solver, world, 2.0);
        const ParticleState state = solver.readParticles();
        heights[more] = meanHeight(world, state, tank.fluids[0]);
        // As quiet as water on one floor.
        EXPECT_LT(rootMeanSquareSpeed(state), 0.05) << more << " more";
    }
    // If it counted twice, the floor would keep water off by a third of a rest distance more, 8 % of 0.2 m; if it
    // counted twice at the edges only, by some 2 %.
    // Measured 0.
    for (int more : {1, 2}) EXPECT_NEAR(heights[more], heights[0], 0.001 * heights[0]) << more << " more";
}

TEST(Fluid, KeepsItsMomentumWithABodyInIt)
{
    WorldBuilder builder = makeBuilder(weightless());
    Material water;
    water.fluid = true;
    const uint32_t material = builder.addMaterial(water);
    addBox(builder, {2, 2, 2}, {}, {0, 0, 1});
    std::vector<Vector3f> places;
    for (int k = 0; k < 11 * 11 * 11; ++k)
        places.push_back(builder.fluidSpacing() * (lattice(k % 11, k / 11 % 11, k / 121) - Vector3f::Constant(5.2f)));
    builder.addFluid(places, {0.5f, 0, 0}, material);
    const World world = builder.build();
    Solver solver(gpu(), world);
    const Totals before = totals(world, solver.readParticles());
    run(solver, world, 1.0);
    const Totals after = totals(world, solver.readParticles());
    // Pressures come in opposite pairs; the rounding of some 500 substeps stays below 2e-4, half of it since
    // what is smoothed is rounded, too.
    EXPECT_LT((after.momentum - before.momentum).norm(), 2e-4 * before.speedSum);
}

}  // namespace

}  // namespace knuckle::test
