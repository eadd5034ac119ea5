#include <cmath>

#include "tests/physics/physics_fixture.h"

namespace knuckle::test {

namespace {

constexpr float APART = 2.0f;  ///< Between wheels, along x: none touches another [m].

JointSpec axleAt(const Vector3f& anchor, const char* name, const TurnDrive& drive = {})
{
    JointSpec spec;
    spec.type = JointType::Hinge;
    spec.name = name;
    spec.anchor = anchor;
    spec.drive = drive;
    spec.geared = true;
    return spec;
}

/// Wheels, flat boxes of so many particles an edge, in a row on hinges of the world along z; each gear is between
/// neighbours. The motor turns the first.
World wheelsInARow(const std::vector<int>& sizes, const std::vector<float>& ratios, const TurnDrive& motor,
                   const Settings& settings = weightless())
{
    WorldBuilder builder = makeBuilder(settings);
    std::vector<HingeBodies> hinges;
    for (size_t i = 0; i < sizes.size(); ++i)
        addBox(builder, {sizes[i], sizes[i], 3}, {{static_cast<float>(i) * APART, 0, 0}});
    for (uint32_t i = 0; i < sizes.size(); ++i) {
        const Vector3f place(static_cast<float>(i) * APART, 0, 0);
        hinges.push_back({builder.joinPlaced(NO_INDEX, i, axleAt(place, "axle", i == 0 ? motor : TurnDrive{})), i});
    }
    for (size_t i = 0; i < ratios.size(); ++i) builder.addGear("gear", hinges[i], hinges[i + 1], ratios[i]);
    return builder.build();
}

/// About z through a body's centre [kg m2].
double inertiaOf(const World& world, uint32_t body)
{
    double inertia = 0;
    for (const Link& link : world.links)
        if (link.body == body) inertia += link.mass * link.restOffset.head<2>().cast<double>().squaredNorm();
    return inertia;
}

/// Angles of bodies about z that go on beyond whole turns.
class Angles {
public:
    explicit Angles(uint32_t count) : turned_(count, 0.0) {}
    void look(const std::vector<BodyState>& bodies)
    {
        for (uint32_t b = 0; b < turned_.size(); ++b) {
            const Vector3f x = bodies[b].rotation * Vector3f::UnitX();
            turned_[b] += std::remainder(std::atan2(x.y(), x.x()) - turned_[b], 2 * M_PI);
        }
    }
    double operator[](uint32_t body) const { return turned_[body]; }

private:
    std::vector<double> turned_;
};

constexpr double DEGREE = M_PI / 180;

}  // namespace

/// A torque M on the first of wheels I, whose neighbours turn by a and by a b as much, speeds it up by
/// M / (I0 + a^2 I1 + (a b)^2 I2). The speed ends within 1 % of the motor's (TurnDrive), so it is asked at half of it.
TEST(Gear, WheelsSpeedUpByTheTorqueOverWhatTheTrainWeighs)
{
    const World world = wheelsInARow({8, 4, 6}, {-2, -0.5f}, speedMotor(6, 10));
    const double weighs = inertiaOf(world, 0) + 4 * inertiaOf(world, 1) + inertiaOf(world, 2);
    Solver solver(gpu(), world);
    const double time = 0.5 * 6 * weighs / 10, h = world.settings.timeStep;
    const int steps = static_cast<int>(std::round(time / h));
    run(solver, world, steps * h);
    EXPECT_NEAR(solver.readBodies()[0].angularVelocity.z(), 10 / weighs * steps * h, 0.02 * 3);
    Angles angles(3);
    double worst = 0;
    for (int i = 0; i < 300; ++i) {
        run(solver, world, h);
        angles.look(solver.readBodies());
        // From where the first look found them, within a turn.
        const double second = angles[1] + 2 * angles[0], third = angles[2] + 0.5 * angles[1];
        worst = std::max({worst, std::abs(std::remainder(second, 2 * M_PI)), std::abs(std::remainder(third, M_PI))});
    }
    EXPECT_LT(worst, 0.05 * DEGREE);
    EXPECT_GT(std::abs(angles[1]), 4 * 2 * M_PI) << "it has hardly turned";
}

/// 40 wheels, each the other way than the one before: as heavy as all of them.
TEST(Gear, ALongTrainTurnsAsOne)
{
    const World world = wheelsInARow(std::vector<int>(40, 4), std::vector<float>(39, -1), speedMotor(3, 20));
    Solver solver(gpu(), world);
    const double h = world.settings.timeStep, rate = 20 / (40 * inertiaOf(world, 0));
    Angles angles(40);
    double worst = 0;
    for (int i = 0; i < 60; ++i) {
        run(solver, world, h);
        angles.look(solver.readBodies());
        worst = std::max(worst, std::abs(angles[39] + angles[0]));
    }
    EXPECT_LT(worst, 0.2 * DEGREE);
    EXPECT_NEAR(solver.readBodies()[0].angularVelocity.z(), std::min(3.0, 60 * h * rate), 0.06);
}

/// Each turns eight times as much as the one before: the first is as heavy as 64^3 times the last's inertia, and more.
TEST(Gear, AHighRatioHolds)
{
    const World world = wheelsInARow({4, 4, 4, 4}, {-8, -8, -8}, speedMotor(0.03f, 4000));
    const double own = inertiaOf(world, 0);
    Solver solver(gpu(), world);
    const double h = world.settings.timeStep, weighs = own * (1 + 64 + 64 * 64 + 64 * 64 * 64);
    const int steps = static_cast<int>(0.5 * 0.03 * weighs / 4000 / h);
    run(solver, world, steps * h);
    EXPECT_NEAR(solver.readBodies()[0].angularVelocity.z(), 4000 / weighs * steps * h, 0.02 * 0.015);
    run(solver, world, 4 * steps * h);
    EXPECT_NEAR(solver.readBodies()[3].angularVelocity.z(), -512 * 0.03, 0.02 * 512 * 0.03);
}

/// The last of three is held for half a second: so are the others, though a motor turns the first.
TEST(Gear, WaitsForWhatIsHeld)
{
    WorldBuilder builder = makeBuilder(weightless());
    std::vector<HingeBodies> hinges;
    for (uint32_t i = 0; i < 3; ++i) {
        builder.beginObject("wheel");
        builder.addBody("wheel", boxLattice({4, 4, 3}, DIAMETER), 0);
        if (i == 2) builder.holdBody(2, 0.5f);
        builder.endObject({{static_cast<float>(i) * APART, 0, 0}});
    }
    for (uint32_t i = 0; i < 3; ++i) {
        const JointSpec axle = axleAt({static_cast<float>(i) * APART, 0, 0}, "axle",
                                      i == 0 ? speedMotor(2, 100) : TurnDrive{});
        hinges.push_back({builder.joinPlaced(NO_INDEX, i, axle), i});
    }
    builder.addGear("gear", hinges[0], hinges[1], 3);
    builder.addGear("gear", hinges[1], hinges[2], -1);
    const World world = builder.build();
    Solver solver(gpu(), world);
    run(solver, world, 0.45);
    EXPECT_NEAR(solver.readBodies()[1].angularVelocity.z(), 0, 0.001);
    Angles angles(3);
    angles.look(solver.readBodies());
    EXPECT_NEAR(angles[0], 0, 0.05 * DEGREE);
    run(solver, world, 2);
    EXPECT_NEAR(solver.readBodies()[2].angularVelocity.z(), -6, 0.06);
}

/// Two level arms, one longer: what turns twice as far balances twice its own moment at the other.
TEST(Gear, TorquesAreAsOneToTheRatio)
{
    for (const float more : {0.97f, 1.03f}) {
        WorldBuilder builder = makeBuilder();
        // A moment of m g l at each; the first's of twice as much.
        addBox(builder, {4, 4, 4}, {{-1.0f * more, 0, 0}});
        addBox(builder, {4, 4, 4}, {{4.5f, 0, 0}});
        const HingeBodies first{builder.joinPlaced(NO_INDEX, 0, axleAt({0, 0, 0}, "first")), 0};
        const HingeBodies second{builder.joinPlaced(NO_INDEX, 1, axleAt({4, 0, 0}, "second")), 1};
        builder.addGear("gear", first, second, 2);
        const World world = builder.build();
        Solver solver(gpu(), world);
        run(solver, world, 0.5);
        const double fallen = solver.readBodies()[0].position.y();
        // 3 % of m g l, against both inertias, in half a second.
        const double moment = 0.03 * GRAVITY * 1.0, weighs = 1.0 + 4 * 0.25 + 0.1;
        const double expected = 0.5 * moment / weighs * 0.25;
        EXPECT_NEAR(fallen, more > 1 ? -expected : expected, 0.3 * expected);
    }
}

/// Two wheels of a frame that nothing holds, one spun: what one gets, the other and the frame lose.
TEST(Gear, OfAFreeFrameKeepsItsAngularMomentum)
{
    WorldBuilder builder = makeBuilder(weightless());
    addBox(builder, {30, 3, 3});
    addBox(builder, {8, 8, 3}, {{-1, 0, 0.4f}}, {0, 0, 0}, {0, 0, 3});
    addBox(builder, {5, 5, 3}, {{1, 0, 0.4f}});
    const HingeBodies first{builder.joinPlaced(0, 1, axleAt({-1, 0, 0.2f}, "first")), 1};
    const HingeBodies second{builder.joinPlaced(0, 2, axleAt({1, 0, 0.2f}, "second")), 2};
    builder.addGear("gear", first, second, -1.5f);
    const World world = builder.build();
    Solver solver(gpu(), world);
    const double before = totals(world, solver.readParticles()).angularMomentum.z();
    Angles angles(3);
    double worst = 0;
    for (int i = 0; i < 180; ++i) {
        run(solver, world, world.settings.timeStep);
        angles.look(solver.readBodies());
        if (i > 10) worst = std::max(worst, std::abs(angles[2] - angles[0] + 1.5 * (angles[1] - angles[0])));
    }
    const Totals after = totals(world, solver.readParticles());
    EXPECT_NEAR(after.angularMomentum.z(), before, 0.005 * before);
    EXPECT_LT(worst, 0.5 * DEGREE);
}

/// The second's axle tears: both then turn by themselves.
TEST(Gear, LetsGoWhereAHingeTears)
{
    WorldBuilder builder = makeBuilder();
    addBox(builder, {4, 4, 3});
    addBox(builder, {4, 4, 3}, {{APART, 0, 0}});
    JointSpec weak = axleAt({APART, 0, 0}, "weak");
    weak.strength.force = 1.0f;
    const HingeBodies first{builder.joinPlaced(NO_INDEX, 0, axleAt({0, 0, 0}, "first", speedMotor(2, 5))), 0};
    const HingeBodies second{builder.joinPlaced(NO_INDEX, 1, weak), 1};
    builder.addGear("gear", first, second, -1);
    const World world = builder.build();
    Solver solver(gpu(), world);
    run(solver, world, 1);
    const std::vector<BodyState> bodies = solver.readBodies();
    EXPECT_NEAR(bodies[1].position.y(), -0.5 * GRAVITY, 0.1);
    EXPECT_NEAR(bodies[1].angularVelocity.z(), 0, 0.2);
    EXPECT_NEAR(bodies[0].angularVelocity.z(), 2, 0.02);
}

}  // namespace knuckle::test
