#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include "tests/physics/animation/moving_fixture.h"
#include "tests/physics/fluid/tank.h"

namespace knuckle::test {

namespace {

constexpr int LAYERS = 8;

uint32_t addHoney(WorldBuilder& builder, float viscosity, float slip = 0.0f)
{
    Material material;
    material.fluid = true;
    material.viscosity = viscosity;
    material.slip = slip;
    return builder.addMaterial(material);
}

/// The mean of |v_y - truth(x)| over what is in the middle of a block, over the largest |truth|.
double profileError(const ParticleState& state, const std::function<double(double)>& truth)
{
    Vector3f centre(0, 0, 0);
    for (const Vector3f& x : state.positions) centre += x / static_cast<float>(state.positions.size());
    double off = 0.0, largest = 0.0;
    int count = 0;
    for (size_t i = 0; i < state.positions.size(); ++i) {
        const Vector3f x = state.positions[i] - centre;
        if (std::max(std::abs(x.y()), std::abs(x.z())) > 0.15f) continue;
        const double right = truth(state.positions[i].x());
        off += std::abs(state.velocities[i].y() - right);
        largest = std::max(largest, std::abs(right));
        ++count;
    }
    return off / count / largest;
}

/// A block of honey, LAYERS thick, between a wall at x = 0 and what the caller adds. A fluid has no lattice, so each
/// particle is up to a quarter of the rest distance away from its place in one.
WorldBuilder atWall(const Settings& settings, float viscosity, float slip = 0.0f)
{
    WorldBuilder builder = makeBuilder(settings);
    const float s = builder.fluidSpacing();
    addPlane(builder, {0, 0, 0}, {1, 0, 0});
    auto places = boxLattice({LAYERS, 20, 12}, s);
    std::mt19937 random(7);
    const auto off = [&] { return 0.25f * s * (static_cast<float>(random()) / 2147483648.0f - 1.0f); };
    for (Vector3f& x : places) {
        const float along = off(), up = off(), deep = off();
        x += Vector3f(0.5f * LAYERS * s + along, up, deep);
    }
    builder.addFluid(places, {0, 0, 0}, addHoney(builder, viscosity, slip));
    return builder;
}

ParticleState after(const World& world, double seconds)
{
    Solver solver(gpu(), world);
    run(solver, world, seconds);
    return solver.readParticles();
}

/// Beside a wall that moves at 0.5 m/s, weightless. What is not steady yet falls by e in (H + 2 slip)^2 / (pi^2 nu),
/// 0.016 s at the most.
ParticleState sheared(float viscosity, float slip)
{
    WorldBuilder builder = atWall(weightless(), viscosity, slip);
    const float height = LAYERS * builder.fluidSpacing();
    addMovingBox(builder, {height + 0.5f, 0, 0}, {0.5f, 3, 3}, straightMotion({0, 0.5f, 0}, 2));
    return after(builder.build(), 0.1);
}

}  // namespace

/// Between a wall and one that moves: u = V x / H. Measured 0.017 and 0.018.
TEST(Viscosity, AWallThatMovesShearsAsCouetteSays)
{
    for (const float viscosity : {1000.0f, 1e4f})
        EXPECT_LT(profileError(sheared(viscosity, 0.0f), [](double x) { return 0.5 * x / 0.4; }), 0.05) << viscosity;
}

/// With a slip length b: u = V (x + b) / (H + 2 b). Measured 0.022.
TEST(Viscosity, ASlipLengthShiftsTheProfile)
{
    EXPECT_LT(profileError(sheared(1e4f, 0.2f), [](double x) { return 0.5 * (x + 0.2) / 0.8; }), 0.05);
}

/// Down between two walls: u = g / (2 nu) x (H - x). No pressure holds the block together, so it is 7 % less dense than
/// at rest and in layers at the walls, as far as that is not made up for: 8 % instead of 5 (measured 0.050 and 0.068).
TEST(Viscosity, AColumnFallsBetweenWallsAsPoiseuilleSays)
{
    for (const float viscosity : {1000.0f, 1e4f}) {
        WorldBuilder builder = atWall({}, viscosity);
        const float height = LAYERS * builder.fluidSpacing();
        addPlane(builder, {height, 0, 0}, {-1, 0, 0});
        const double nu = viscosity / 1000.0;
        const auto truth = [&](double x) { return -GRAVITY / (2.0 * nu) * x * (height - x); };
        EXPECT_LT(profileError(after(builder.build(), 0.1), truth), 0.08) << viscosity;
    }
}

/// A ball whose middle turns faster than its rim. Pair forces keep angular momentum; pressures, along lines between
/// predicted places, to 7e-5 in a quarter of a second. Momentum is left from rounding alone, 6e-5.
TEST(Viscosity, ABlobThatTurnsKeepsItsAngularMomentum)
{
    for (const float viscosity : {1.0f, 100.0f, 1e4f}) {
        WorldBuilder builder = makeBuilder(weightless());
        builder.addFluid(sphereLattice(0.2f, builder.fluidSpacing()), {0, 0, 0}, addHoney(builder, viscosity));
        World world = builder.build();
        for (Particle& p : world.particles)
            p.velocity = (p.position.head<2>().norm() < 0.1f ? 1.0f : 0.3f) * Vector3f::UnitZ().cross(p.position);
        Solver solver(gpu(), world);
        run(solver, world, world.settings.timeStep);  // what is too dense at the start moves apart
        const Totals before = totals(world, solver.readParticles());
        run(solver, world, 0.25);
        const Totals now = totals(world, solver.readParticles());
        const double all = before.angularMomentum.z();
        EXPECT_LT((now.angularMomentum - before.angularMomentum).norm(), 3e-4 * all) << viscosity;
        EXPECT_LT(now.momentum.norm(), 1e-4 * now.speedSum) << viscosity;
        // It ends as a solid turns: the energy is L^2 / (2 I).
        double inertia = 0.0;
        const ParticleState state = solver.readParticles();
        for (const Vector3f& x : state.positions) inertia += world.particles[0].mass * x.head<2>().squaredNorm();
        if (viscosity > 10.0f) {
            EXPECT_NEAR(solver.measure().kineticEnergy, all * all / (2 * inertia), 1e-3 * all);
        }
    }
}

namespace {

float medianRadius(const ParticleState& state)
{
    std::vector<float> radii;
    for (const Vector3f& x : state.positions) radii.push_back(std::hypot(x.x(), x.z()));
    const auto middle = radii.begin() + static_cast<std::ptrdiff_t>(radii.size() / 2);
    std::ranges::nth_element(radii, middle);
    return *middle;
}

/// A cube of honey of 0.4 m on a floor, 1400 kg/m3. @param edge  particles
World honeyCube(float viscosity, int edge)
{
    WorldBuilder builder(0.4f / static_cast<float>(edge));
    builder.addMaterial({});
    addPlane(builder, {0, 0, 0}, {0, 1, 0});
    Material honey;
    honey.fluid = true;
    honey.density = 1400;
    honey.viscosity = viscosity;
    auto places = boxLattice({edge, edge, edge}, builder.fluidSpacing());
    for (Vector3f& x : places) x.y() += 0.2f;
    builder.addFluid(places, {0, 0, 0}, builder.addMaterial(honey));
    return builder.build();
}

/// Huppert 1982: the puddle's radius is 0.894 (g V^3 t / (3 nu))^(1/8), its height in proportion to (1 - r^2)^(1/3), so
/// half of it lies within sqrt(1 - 0.5^(3/4)) of that radius.
double huppertMedian(double viscosity, double time)
{
    const double radius = 0.894 * std::pow(GRAVITY * std::pow(0.064, 3) * time / (3.0 * viscosity / 1400.0), 0.125);
    return std::sqrt(1.0 - std::pow(0.5, 0.75)) * radius;
}

}  // namespace

/// Measured 1.01, 0.99 and 0.95 of it, the last with a puddle of 1.3 particles on the average. The radius goes with the
/// eighth root of the viscosity.
TEST(Viscosity, ACubeOfHoneySpreadsAsHuppertSays)
{
    const World world = honeyCube(10.0f, 12);
    Solver solver(gpu(), world);
    for (const double time : {0.5, 1.0, 1.5}) {
        run(solver, world, 0.5);
        const double truth = huppertMedian(10.0, time);
        EXPECT_NEAR(medianRadius(solver.readParticles()), truth, 0.1 * truth) << time;
    }
}

/// A cube at 1000 Pa s is no thin puddle yet after 0.4 s: wider than at the start, 0.16 m, and behind Huppert's.
TEST(Viscosity, ACubeOfLavaSinksDownSlowly)
{
    const World world = honeyCube(1000.0f, 10);
    const float radius = medianRadius(after(world, 0.4));
    EXPECT_GT(radius, 0.17f);
    EXPECT_LT(radius, huppertMedian(1000.0, 0.4));
}

}  // namespace knuckle::test
