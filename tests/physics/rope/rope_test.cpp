#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "sim/world/builder/parts/rope.h"
#include "tests/physics/physics_fixture.h"

namespace knuckle::test {

namespace {

constexpr float LENGTH = 2.0f;

/// Mass of a rope of the tests' material [kg]: each end has half of a particle.
double ropeMass(const World& world)
{
    double mass = 0.0;
    for (const Particle& p : world.particles) mass += p.body == NO_INDEX ? p.mass : 0.0;
    return mass;
}

/// A cube hangs below the origin on a rope along -y. @returns the cube's body.
uint32_t hangCube(WorldBuilder& builder, const RopeSpec& common, uint32_t material)
{
    RopeSpec rope = common;
    rope.to = {0, -LENGTH, 0};
    rope.start.kind = RopeEnd::Kind::Fixed;
    builder.beginObject("cube");
    const uint32_t body = builder.addBody("cube", boxLattice({3, 3, 3}, DIAMETER), material);
    builder.endObject({{0, -LENGTH - DIAMETER, 0}});
    // The middle of its upper side.
    rope.end = {RopeEnd::Kind::Attached, particleAt(builder, rope.to)};
    addRope(builder, "rope", rope);
    return body;
}

/// The length of a world's only rope: the sum of its distances [m].
double lengthOf(const World& world, const ParticleState& state)
{
    double length = 0.0;
    const auto& nodes = world.strands[0].particles;
    for (size_t k = 1; k < nodes.size(); ++k)
        length += (state.positions[nodes[k]] - state.positions[nodes[k - 1]]).cast<double>().norm();
    return length;
}

double meanLength(const World& world, double settle)
{
    Solver solver(gpu(), world);
    run(solver, world, settle);
    double sum = 0.0;
    for (int i = 0; i < 120; ++i) {
        run(solver, world, world.settings.timeStep);
        sum += lengthOf(world, solver.readParticles());
    }
    return sum / 120;
}

}  // namespace

/// Extension of a rope of `compliance` by a cube of that density, over load times compliance.
double stretchShare(float density, float compliance, uint32_t iterations)
{
    Settings settings;
    settings.iterations = iterations;
    settings.linearDamping = 4;  // so that it stops bouncing
    WorldBuilder builder = makeBuilder(settings);
    Material material;
    material.density = density;
    RopeSpec rope;
    rope.compliance = compliance;
    hangCube(builder, rope, builder.addMaterial(material));
    const World world = builder.build();
    // Each link carries everything below it: on average half of the rope's own weight.
    const double load = (world.bodies.front().mass + 0.5 * ropeMass(world)) * GRAVITY;
    return (meanLength(world, 2.5) - LENGTH) / (load * compliance);
}

TEST(Rope, IsLongerByWeightTimesComplianceAtAnyNumberOfIterations)
{
    // 19 kg of rope and a cube of 27: by 3.6 cm.
    for (uint32_t iterations : {1u, 2u, 10u})
        // Measured 2.1e-5.
        EXPECT_NEAR(stretchShare(1000, 1e-4f, iterations), 1.0, 2e-4) << iterations << " iterations";
}

TEST(Rope, CarriesAHundredTimesItsWeightWithoutGettingLonger)
{
    // 2000 kg on 19 kg. The particle at the rope's end falls short by the remainder of one iteration, of g h^2, 0.2 mm
    // at 1/240 s, times a few per cent.
    for (uint32_t iterations : {1u, 10u}) {
        Settings settings;
        settings.iterations = iterations;
        WorldBuilder builder = makeBuilder(settings);
        Material material;
        material.density = 74000;
        hangCube(builder, {}, builder.addMaterial(material));
        EXPECT_NEAR(meanLength(builder.build(), 1), LENGTH, 1e-4 * LENGTH) << iterations << " iterations";
    }
}

/// A rope from the origin to `to` with a loose particle of `mass` at its end [kg]. @returns its index.
uint32_t addPendulum(WorldBuilder& builder, const Vector3f& to, float mass)
{
    Particle bob;
    bob.position = to;
    bob.mass = mass;
    const uint32_t index = builder.addLooseParticle(bob);
    RopeSpec rope;
    rope.start.kind = RopeEnd::Kind::Fixed;
    rope.end = {RopeEnd::Kind::Attached, index};
    addRope(builder, "rope", rope);
    return index;
}

/// The slowest period of small swings of a hanging chain, from its nodes' masses from the top down [s]: the tension in
/// a link is the weight below it, and pulls its ends together sideways by tension over length.
double slowestPeriod(const std::vector<double>& masses, double link)
{
    const auto n = static_cast<Eigen::Index>(masses.size());
    Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(n, n), inertia = Eigen::MatrixXd::Zero(n, n);
    double below = 0.0;
    for (Eigen::Index k = n - 1; k >= 0; --k) {
        below += masses[static_cast<size_t>(k)];
        inertia(k, k) = masses[static_cast<size_t>(k)];
        const double pull = below * GRAVITY / link;  // of the link above the node
        stiffness(k, k) += pull;
        if (k == 0) continue;
        stiffness(k - 1, k - 1) += pull;
        stiffness(k, k - 1) -= pull;
        stiffness(k - 1, k) -= pull;
    }
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> modes(stiffness, inertia);
    return 2 * M_PI / std::sqrt(modes.eigenvalues()[0]);
}

void expectSwing(float mass)
{
    WorldBuilder builder = makeBuilder();
    const float angle = 0.1f;
    const uint32_t bob = addPendulum(builder, {LENGTH * std::sin(angle), -LENGTH * std::cos(angle), 0}, mass);
    const World world = builder.build();
    std::vector<double> masses;
    const auto& nodes = world.strands[0].particles;
    for (size_t k = 1; k < nodes.size(); ++k) masses.push_back(world.particles[nodes[k]].mass);
    // The finite-amplitude correction 1 + a^2/16 is 0.06 % at 0.1 rad.
    const double truth = slowestPeriod(masses, world.strands[0].restLengths[0]);
    Solver solver(gpu(), world);
    std::vector<double> crossings;
    double last = 0.0, furthest = 0.0;
    const double h = world.settings.timeStep;
    for (int i = 1; i * h < 5.5 * truth; ++i) {
        run(solver, world, h);
        const double x = solver.readParticles().positions[bob].x();
        furthest = i * h < 4.5 * truth ? 0.0 : std::max(furthest, std::abs(x));
        if (last > 0.0 && x <= 0.0) crossings.push_back((i - 1 + last / (last - x)) * h);
        last = x;
    }
    ASSERT_GE(crossings.size(), 5u);
    EXPECT_NEAR((crossings[4] - crossings[0]) / 4, truth, 0.01 * truth);
    EXPECT_GT(furthest, 0.95 * LENGTH * std::sin(angle));
    EXPECT_NEAR(lengthOf(world, solver.readParticles()), LENGTH, 7e-5 * LENGTH);  // measured 9e-6
}

TEST(Rope, SwingsWithTheChainsOwnPeriod)
{
    expectSwing(20.0f);
}

TEST(Rope, SwingsUnderALoadOfTwoThousandOfItsParticles)
{
    expectSwing(2000.0f);
}

TEST(Rope, KeepsItsMomentumWhenItIsFree)
{
    // A whirling rope with one heavier end: 1e-4 of its parts' momentum, as for bodies.
    WorldBuilder builder = makeBuilder(weightless());
    addPendulum(builder, {0, -LENGTH, 0}, 5.0f);
    World world = builder.build();
    for (Particle& p : world.particles) p.velocity = Vector3f(3 * p.position.y() + 1, p.position.y(), -p.position.y());
    for (Body& body : world.bodies) body.motion = Motion::Dynamic;
    Solver solver(gpu(), world);
    const Totals before = totals(world, solver.readParticles());
    run(solver, world, 2);
    const Totals after = totals(world, solver.readParticles());
    EXPECT_LT((after.momentum - before.momentum).norm(), 1e-4 * before.speedSum);
    EXPECT_GT(after.speedSum, 0.5 * before.speedSum);
}

TEST(Rope, HangsInACatenary)
{
    // Length 3 over a span of 2: 2 a sinh(1/a) = 3 for a = 0.61647, sag a (cosh(1/a) - 1).
    const double a = 0.61647, sag = a * (std::cosh(1 / a) - 1);
    WorldBuilder builder = makeBuilder();
    RopeSpec rope;
    rope.from = {-1, 0, 0};
    rope.to = {1, 0, 0};
    rope.length = 3;
    rope.start.kind = rope.end.kind = RopeEnd::Kind::Fixed;
    addRope(builder, "rope", rope);
    const World world = builder.build();
    Solver solver(gpu(), world);
    run(solver, world, 2);
    for (const Vector3f& x : solver.readParticles().positions)
        // A chain of 30 links lies inside its curve by link^2 / (8 radius), 2 mm; required: 1 % of the sag.
        EXPECT_NEAR(x.y(), a * std::cosh(x.x() / a) - a - sag, 0.006 * sag) << "at x " << x.x();  // measured 7e-4
}

/// Whether a cube of 27 kg stays on its rope, which weighs 19 kg.
bool holds(float tearForce)
{
    Settings settings;
    settings.linearDamping = 4;
    WorldBuilder builder = makeBuilder(settings);
    RopeSpec rope;
    rope.tearForce = tearForce;
    const uint32_t cube = hangCube(builder, rope, 0);
    const World world = builder.build();
    Solver solver(gpu(), world);
    run(solver, world, 1.5);
    return solver.readBodies()[cube].position.y() > -LENGTH - 1.1f * DIAMETER;
}

TEST(Rope, TearsAtItsForce)
{
    // Its first link carries 26.5 kg of cube (its particle belongs to the joint) and 19.5 of rope: 456 N. It starts
    // without tension and reaches that from below within a substep, as it does not stretch.
    const float load = static_cast<float>(GRAVITY) * (27.0f + 19.0f);
    EXPECT_TRUE(holds(1.1f * load));
    EXPECT_FALSE(holds(0.9f * load));
}

}  // namespace knuckle::test
