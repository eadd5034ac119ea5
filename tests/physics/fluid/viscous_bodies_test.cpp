#include <fmt/format.h>

#include <cmath>
#include <numbers>

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

/// A ball of 19 particles sinks in a full tank of honey. @returns its mean speed in the last 0.1 s [m/s].
double sinkBall(float viscosity, int wide, int layers, double seconds)
{
    WorldBuilder builder = makeBuilder();
    const float s = builder.fluidSpacing(), radius = 0.15f;
    Material heavy;
    heavy.density = 3000.0f;
    const uint32_t ball = builder.addMaterial(heavy), fluid = addHoney(builder, viscosity);
    addWalls(builder, s * float(wide), s * float(wide));
    const Vector3f middle(0.5f * s * float(wide), 0.55f * s * float(layers), 0.5f * s * float(wide));
    builder.beginObject("ball");
    builder.addBody("ball", sphereLattice(radius, DIAMETER), ball);
    builder.endObject({middle});
    std::vector<Vector3f> places;
    for (int k = 0; k < wide * layers * wide; ++k) {
        const Vector3f x = s * (lattice(k % wide, k / wide % layers, k / (wide * layers)) + Vector3f::Constant(0.5f));
        if ((x - middle).norm() > radius + 0.4f * s) places.push_back(x);
    }
    builder.addFluid(places, {0, 0, 0}, fluid);
    const World world = builder.build();
    Solver solver(gpu(), world);
    run(solver, world, seconds - 0.1);
    const float before = solver.readBodies()[0].position.y();
    run(solver, world, 0.1);
    return (before - solver.readBodies()[0].position.y()) / 0.1;
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
    EXPECT_NO_THROW(sinkBall(1e4f, 12, 12, 0.2));
}

/// A ball sinks as Stokes has it, between walls as Faxen (1923; Happel and Brenner 1965, section 7-3) has it in a
/// cylinder; a square duct is as one 1.1057 times as wide (Happel and Bart 1974, by the first terms).
TEST(ViscousBodies, ABallSinksAsStokesSays)
{
    constexpr double HALF = 0.4, VISCOSITY = 1000.0, EXCESS = 2000.0, VOLUME = 19e-3;
    // The cubes that fluids feel stick out of the ball of their volume: one alone is dragged as a ball of 1.065 of the
    // radius. 10 %: for what lies between, and for floor and surface, three radii away.
    const double radius = 1.03 * std::cbrt(VOLUME * 3.0 / (4.0 * std::numbers::pi)), l = radius / (1.1057 * HALF);
    const double alone = EXCESS * VOLUME * GRAVITY / (6.0 * std::numbers::pi * VISCOSITY * radius);
    const double walls = 1.0 - 2.10444 * l + 2.08877 * std::pow(l, 3) - 0.94813 * std::pow(l, 5) -
                         1.372 * std::pow(l, 6) + 3.87 * std::pow(l, 8) - 4.19 * std::pow(l, 10);
    const double truth = alone * walls;
    EXPECT_NEAR(sinkBall(float(VISCOSITY), 16, 20, 0.75), truth, 0.1 * truth);
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
