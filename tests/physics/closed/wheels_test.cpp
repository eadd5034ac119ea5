#include <algorithm>
#include <cmath>

#include "tests/physics/physics_fixture.h"

namespace knuckle::test {

namespace {

/// About z through its centre [kg m2].
double inertiaOf(const World& world, uint32_t body)
{
    double inertia = 0;
    for (const Link& link : world.links)
        if (link.body == body) inertia += link.mass * link.restOffset.head<2>().squaredNorm();
    return inertia;
}

double angleOf(Solver& solver, uint32_t body)
{
    const Vector3f x = solver.readBodies()[body].rotation * Vector3f::UnitX();
    return std::atan2(x.y(), x.x());
}

JointSpec axleAt(const Vector3f& place, const TurnDrive& drive)
{
    JointSpec spec;
    spec.type = JointType::Hinge;
    spec.anchor = place;
    spec.drive = drive;
    return spec;
}

TurnDrive springTo(float stiffness, double angle)
{
    TurnDrive drive;
    drive.stiffness = stiffness;
    drive.angle = static_cast<float>(angle);
    return drive;
}

/// Two wheels on one axle, held by a spring each, the first to the world and the second to the first. At rest they are
/// turned by a and b.
World wheelsOnSprings(float stiffness, double a, double b)
{
    WorldBuilder builder = makeBuilder(weightless());
    for (const float z : {0.0f, 0.6f}) addBox(builder, {8, 8, 3}, {Vector3f(0, 0, z)});
    builder.joinPlaced(NO_INDEX, 0, axleAt({0, 0, 0}, springTo(stiffness, a)));
    builder.joinPlaced(0, 1, axleAt({0, 0, 0.3f}, springTo(stiffness, b - a)));
    return builder.build();
}

}  // namespace

/// Their modes: the second goes (1 + sqrt 5) / 2 or (1 - sqrt 5) / 2 times as far as the first, at w^2 = k / I times
/// (3 - sqrt 5) / 2 or (3 + sqrt 5) / 2.
TEST(ClosedWheels, TwoOnSpringsRingInTheirModes)
{
    constexpr float STIFFNESS = 200.0f;
    for (const double root : {std::sqrt(5.0), -std::sqrt(5.0)}) {
        const double a = 0.2, b = a * 0.5 * (1 + root);
        const World world = wheelsOnSprings(STIFFNESS, a, b);
        const double w = std::sqrt(STIFFNESS / inertiaOf(world, 0) * 0.5 * (3 - root)), truth = M_PI / w;
        Solver solver(gpu(), world);
        std::vector<double> crossings;
        double last = -a;
        const double step = world.settings.timeStep;
        for (int k = 1; crossings.size() < 5 && k < 600; ++k) {
            run(solver, world, step);
            const double now = angleOf(solver, 0) - a;
            if (now * last < 0) crossings.push_back((k - now / (now - last)) * step);
            last = now;
            // A mode stays one; what the other takes part in it comes from the joint's first substeps.
            EXPECT_NEAR((angleOf(solver, 1) - b) * a, now * b, 0.05 * a * std::abs(b));
        }
        ASSERT_EQ(crossings.size(), 5u);
        const double half = (crossings[4] - crossings[0]) / 4;
        // BDF2 lengthens a period by (w h)^2 / 3; the faster mode has w h = 0.04.
        EXPECT_NEAR(half, truth, 0.01 * truth);
    }
}

/// A motor between a free wheel and a free frame turns them against each other, as 1 to their moments, and brings no
/// momentum.
TEST(ClosedWheels, AReactionWheelTurnsItsFrameBack)
{
    WorldBuilder builder = makeBuilder(weightless());
    addBox(builder, {12, 12, 3});
    addBox(builder, {6, 6, 3}, {Vector3f(0, 0, 0.6f)});
    builder.joinPlaced(0, 1, axleAt({0, 0, 0.3f}, speedMotor(6, 40)));
    const World world = builder.build();
    const double frame = inertiaOf(world, 0), wheel = inertiaOf(world, 1);
    Solver solver(gpu(), world);
    run(solver, world, 2.0);
    const auto bodies = solver.readBodies();
    const double truth = 6 * wheel / (wheel + frame);
    // Their joint's own particles weigh next to nothing; a motor keeps its speed to 0.1 %.
    EXPECT_NEAR(bodies[0].angularVelocity.z(), -truth, 0.01 * truth);
    EXPECT_NEAR(bodies[1].angularVelocity.z(), 6 - truth, 0.01 * 6);
    EXPECT_NEAR(frame * bodies[0].angularVelocity.z() + wheel * bodies[1].angularVelocity.z(), 0, 0.002 * 6 * wheel);
}

/// A soft bar of length L that is held by one end and let go swings along itself: its end is furthest, twice as far as
/// it will hang, when the wave comes back, 2 L / c, c = sqrt(E / rho) the speed of sound in a bar.
TEST(ClosedWheels, ASoftBarSwingsAtTheSpeedOfSoundInIt)
{
    constexpr float STIFFNESS = 2e4f, PULL = 1.0f;
    Settings settings;
    settings.gravity = {0, -PULL, 0};
    WorldBuilder builder(DIAMETER / 2, settings);
    Material material;
    material.elasticity.stiffness = STIFFNESS;
    material.elasticity.poissonRatio = 0.0f;
    material.elasticity.damping = 0.0f;
    builder.addMaterial(material);
    const std::vector<Vector3f> lattice = boxLattice({3, 13, 3}, DIAMETER);
    std::vector<uint32_t> pins;
    for (uint32_t i = 0; i < lattice.size(); ++i)
        if (lattice[i].y() > 5.5f * DIAMETER) pins.push_back(i);
    builder.beginObject("bar");
    builder.addSoftBody("bar", lattice, 0, pins);
    builder.endObject();
    const World world = builder.build();
    Solver solver(gpu(), world);
    const double length = 12.5 * double{DIAMETER}, sound = std::sqrt(double{STIFFNESS} / 1000.0),
                 truth = 2 * length / sound;
    const double step = world.settings.timeStep;
    std::vector<double> depths = {0};
    for (int k = 1; k * step < 1.5 * truth; ++k) {
        run(solver, world, step);
        depths.push_back(double{world.particles[0].position.y() - solver.readParticles().positions[0].y()});
    }
    const auto deepest = static_cast<size_t>(std::ranges::max_element(depths) - depths.begin());
    ASSERT_LT(deepest + 1, depths.size());
    const double before = depths[deepest - 1], most = depths[deepest], after = depths[deepest + 1];
    const double at = (static_cast<double>(deepest) + 0.5 * (after - before) / (2 * most - before - after)) * step;
    const double sag = 1000.0 * double{PULL} * length * length / (2.0 * double{STIFFNESS});
    // It gets slower as it gets longer, by the mean of its strain, 3 %; what damping is left takes some of its depth.
    EXPECT_NEAR(at, truth, 0.03 * truth);
    EXPECT_NEAR(most, 2 * sag, 0.1 * sag);
}

}  // namespace knuckle::test
