#include <fmt/format.h>

#include <cmath>

#include "tests/physics/fluid/tank.h"

namespace knuckle::test {

namespace {

uint32_t addHoney(WorldBuilder& builder, float viscosity)
{
    Material honey;
    honey.fluid = true;
    honey.viscosity = viscosity;
    return builder.addMaterial(honey);
}

/// A ball sinks in a full tank of honey.
void sinkBall(float viscosity)
{
    constexpr int WIDE = 12, LAYERS = 12;
    WorldBuilder builder = makeBuilder();
    const float s = builder.fluidSpacing(), radius = 0.15f;
    Material heavy;
    heavy.density = 3000.0f;
    const uint32_t ball = builder.addMaterial(heavy), fluid = addHoney(builder, viscosity);
    addWalls(builder, s * WIDE, s * WIDE);
    const Vector3f middle(0.5f * s * WIDE, 0.6f * s * LAYERS, 0.5f * s * WIDE);
    builder.beginObject("ball");
    builder.addBody("ball", sphereLattice(radius, DIAMETER), ball);
    builder.endObject({middle});
    std::vector<Vector3f> places;
    for (int k = 0; k < WIDE * LAYERS * WIDE; ++k) {
        const Vector3f x = s * (lattice(k % WIDE, k / WIDE % LAYERS, k / (WIDE * LAYERS)) + Vector3f::Constant(0.5f));
        if ((x - middle).norm() > radius + 0.4f * s) places.push_back(x);
    }
    builder.addFluid(places, {0, 0, 0}, fluid);
    const World world = builder.build();
    Solver solver(gpu(), world);
    run(solver, world, 0.2);
}

}  // namespace

/// A ball flies into the middle of honey without weight, which takes it along: what one loses the other gets.
TEST(ViscousBodies, ABallAndTheHoneyAroundItKeepTheirMomentum)
{
    WorldBuilder builder = makeBuilder(weightless());
    builder.beginObject("ball");
    builder.addBody("ball", sphereLattice(0.15f, DIAMETER), 0);
    builder.endObject({}, {0, -0.5f, 0});
    std::vector<Vector3f> places;
    for (const Vector3f& x : sphereLattice(0.35f, builder.fluidSpacing()))
        if (x.norm() > 0.2f) places.push_back(x);
    builder.addFluid(places, {0, 0, 0}, addHoney(builder, 500.0f));
    const World world = builder.build();
    Solver solver(gpu(), world);
    const Totals before = totals(world, solver.readParticles());
    run(solver, world, 0.3);
    const Totals now = totals(world, solver.readParticles());
    EXPECT_LT((now.momentum - before.momentum).norm(), 1e-3 * before.momentum.norm());
    // It moves as all do together.
    float mass = 0.0f;
    for (const Particle& p : world.particles) mass += p.mass;
    const auto together = static_cast<float>(before.momentum.y()) / mass;
    EXPECT_NEAR(solver.readBodies()[0].velocity.y(), together, 0.05f * 0.5f);
}

/// A full tank of the thickest settles. With one solve instead of two halves it would gain energy, which ends a run.
TEST(ViscousBodies, AFullTankOfTheThickestSettles)
{
    EXPECT_NO_THROW(sinkBall(1e4f));
}

/// Honey falls into water with a light raft, for any substeps. It arrives at 3.6 m/s; a front that meets a wall
/// turns up at no more than twice that.
TEST(ViscousBodies, AnyViscosityIsStableAtAnySubsteps)
{
    for (const uint32_t substeps : {4u, 30u})
        for (const float viscosity : {0.2f, 30.0f, 1e4f}) {
            Settings settings;
            settings.substeps = substeps;
            Tank tank(8, 5, 8, {1000.0f}, settings);
            auto places = boxLattice({4, 7, 4}, tank.builder.fluidSpacing());
            for (Vector3f& x : places) x += Vector3f(0.2f, 0.55f, 0.2f);
            tank.builder.addFluid(places, {0, -1, 0}, addHoney(tank.builder, viscosity));
            Material light;
            light.density = 100;
            tank.builder.beginObject("raft");
            tank.builder.addBody("raft", boxLattice({2, 1, 2}, DIAMETER), tank.builder.addMaterial(light));
            tank.builder.endObject({{0.2f, 0.9f, 0.2f}});
            const World world = tank.builder.build();
            Solver solver(gpu(), world);
            for (int k = 0; k < 6; ++k) {
                const auto what = fmt::format("{} substeps, {} Pa s", substeps, viscosity);
                ASSERT_NO_THROW(run(solver, world, 0.05)) << what;
                EXPECT_LT(solver.measure().maxSpeed, 7.2f) << what;
            }
        }
}

}  // namespace knuckle::test
