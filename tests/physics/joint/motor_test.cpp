#include <cmath>
#include <functional>
#include <limits>

#include "tests/physics/physics_fixture.h"

namespace knuckle::test {

namespace {

/// A wheel, a flat box, on a hinge of the world along z through its centre at the origin.
struct Wheel {
    World world;
    double inertia = 0;  ///< About the hinge [kg m2].
};

Wheel wheelOn(const TurnDrive& drive, const Settings& settings = weightless(), const Vector3f& hinge = {0, 0, 0})
{
    WorldBuilder builder = makeBuilder(settings);
    addBox(builder, {8, 8, 3});
    JointSpec spec;
    spec.type = JointType::Hinge;
    spec.name = "axle";
    spec.anchor = hinge;
    spec.drive = drive;
    builder.joinPlaced(NO_INDEX, 0, spec);
    Wheel wheel{builder.build()};
    for (const Link& link : wheel.world.links) {
        if (link.body != 0) continue;
        const Vector3f arm = link.restOffset + wheel.world.bodies[0].restCentre - hinge;
        wheel.inertia += link.mass * (arm.x() * arm.x() + arm.y() * arm.y());
    }
    return wheel;
}

const Vector3f ARM_HINGE(-0.8f, 0, 0);

/// The same, hung level beside its hinge, with its weight.
Wheel armOn(const TurnDrive& drive)
{
    return wheelOn(drive, {}, ARM_HINGE);
}

/// The torque of its weight [N m].
double armMoment()
{
    return armOn(speedMotor(1, 1)).world.bodies[0].mass * GRAVITY * -ARM_HINGE.x();
}

TurnDrive spring(float stiffness, float damping = 0)
{
    TurnDrive drive;
    drive.stiffness = stiffness;
    drive.damping = damping;
    return drive;
}

double speedOf(Solver& solver, uint32_t body = 0)
{
    return solver.readBodies()[body].angularVelocity.z();
}

double angleOf(Solver& solver, uint32_t body = 0)
{
    const Vector3f x = solver.readBodies()[body].rotation * Vector3f::UnitX();
    return std::atan2(x.y(), x.x());
}

/// Times of its passing 0, upwards and downwards.
std::vector<double> crossingsOf(const std::function<double()>& value, Solver& solver, const World& world, size_t count)
{
    std::vector<double> crossings;
    const double h = world.settings.timeStep;
    double last = value();
    for (int i = 1; crossings.size() < count && i * h < 20; ++i) {
        run(solver, world, h);
        const double now = value();
        if (last * now < 0) crossings.push_back((i - 1 + last / (last - now)) * h);
        last = now;
    }
    return crossings;
}

}  // namespace

/// 10 N m until 4 rad/s, either way.
TEST(Motor, AWheelSpeedsUpByTorqueOverInertiaAndKeepsItsSpeed)
{
    for (const float speed : {4.0f, -4.0f}) {
        Wheel wheel = wheelOn(speedMotor(speed, 10));
        const double rate = std::copysign(10 / wheel.inertia, speed), time = speed / rate;
        Solver solver(gpu(), wheel.world);
        run(solver, wheel.world, 0.5 * time);
        EXPECT_NEAR(speedOf(solver), 0.5 * speed, std::abs(0.02 * speed));
        run(solver, wheel.world, 0.4 * time);
        EXPECT_NEAR(speedOf(solver), 0.9 * speed, std::abs(0.02 * speed));
        run(solver, wheel.world, 0.4 * time);
        EXPECT_NEAR(speedOf(solver), speed, std::abs(0.005 * speed));
        run(solver, wheel.world, 2);
        EXPECT_NEAR(speedOf(solver), speed, std::abs(0.001 * speed));
    }
}

/// An arm level beside its hinge, of weight m g and length l: a torque of 0.9 m g l lowers it, 1.1 lifts it.
TEST(Motor, StallsUnderALoadOfMoreThanItsTorque)
{
    const double moment = armMoment();
    for (const double part : {0.9, 1.1}) {
        const Wheel arm = armOn(speedMotor(0.5f, static_cast<float>(part * moment)));
        Solver solver(gpu(), arm.world);
        run(solver, arm.world, 0.3);
        // From the level, by what one leaves of the other.
        const double fallen = 0.5 * (part - 1) * moment / arm.inertia * 0.3 * 0.3;
        if (part < 1) {
            EXPECT_NEAR(angleOf(solver), fallen, 0.05 * std::abs(fallen));
        } else {
            EXPECT_NEAR(angleOf(solver), fallen, 0.05 * fallen);
            run(solver, arm.world, 0.5);
            EXPECT_NEAR(speedOf(solver), 0.5, 0.01);
        }
    }
}

TEST(Motor, AngleMotorTurnsThereAndHoldsALoadBelowItsTorqueOnly)
{
    const double moment = armMoment();
    for (const double part : {0.8, 1.25}) {
        const Wheel arm = armOn(angleMotor(0, static_cast<float>(part * moment)));
        Solver solver(gpu(), arm.world);
        run(solver, arm.world, 1);
        const double degrees = angleOf(solver) * 180 / M_PI;
        if (part > 1) {
            EXPECT_NEAR(degrees, -0.8, 0.05);
        } else {
            EXPECT_LT(degrees, -20);
        }
    }
}

/// Two turns and a half; and with a speed.
TEST(Motor, AngleMotorCountsWholeTurnsAndKeepsToItsSpeed)
{
    const auto angle = static_cast<float>(5 * M_PI);
    for (const float speed : {2.0f, std::numeric_limits<float>::infinity()}) {
        const Wheel wheel = wheelOn(angleMotor(angle, 400, speed));
        Solver solver(gpu(), wheel.world);
        double turned = 0, fastest = 0;
        for (int i = 0; i < 600; ++i) {
            run(solver, wheel.world, wheel.world.settings.timeStep);
            turned += speedOf(solver) * wheel.world.settings.timeStep;
            fastest = std::max(fastest, speedOf(solver));
        }
        EXPECT_NEAR(turned, angle, 0.02 * angle);
        EXPECT_NEAR(std::abs(angleOf(solver)), M_PI, 0.01);
        if (std::isfinite(speed)) {
            EXPECT_NEAR(fastest, 2, 0.02);
        } else {
            EXPECT_GT(fastest, 4);
        }
    }
}

/// Between two free wheels one's gain is the other's loss, and the inertia that swings is half of each.
TEST(JointSpring, RingsAsStiffnessAndInertiaSay)
{
    for (const bool free : {false, true}) {
        Wheel wheel = wheelOn(spring(200));
        if (free) {
            WorldBuilder builder = makeBuilder(weightless());
            for (const float z : {0.0f, 0.5f})
                addBox(builder, {8, 8, 3}, {{0, 0, z}}, {0, 0, 0}, {0, 0, z > 0 ? -1.0f : 1.0f});
            JointSpec spec;
            spec.type = JointType::Hinge;
            spec.anchor = {0, 0, 0.25f};
            spec.drive = spring(200);
            builder.joinPlaced(1, 0, spec);
            wheel.world = builder.build();
            wheel.inertia /= 2;
        } else {
            TurnDrive wound = spring(200);
            wound.angle = 0.4f;
            wheel.world = wheelOn(wound).world;
        }
        Solver solver(gpu(), wheel.world);
        const std::vector<double> at = crossingsOf([&] { return free ? angleOf(solver) : angleOf(solver) - 0.4; },
                                                   solver, wheel.world, 9);
        ASSERT_EQ(at.size(), 9u);
        const double period = 2 * M_PI * std::sqrt(wheel.inertia / 200);
        EXPECT_NEAR((at[8] - at[0]) / 4, period, 0.01 * period);
        if (free) {
            EXPECT_NEAR(speedOf(solver, 0), -speedOf(solver, 1), 0.01);
        }
    }
}

/// exp(-damping t / I) of its speed.
TEST(JointSpring, ADamperAloneSlowsExponentially)
{
    WorldBuilder builder = makeBuilder(weightless());
    addBox(builder, {8, 8, 3}, {}, {0, 0, 0}, {0, 0, 3});
    JointSpec spec;
    spec.type = JointType::Hinge;
    const Wheel same = wheelOn(spring(0, 20));
    spec.drive = spring(0, 20);
    builder.joinPlaced(NO_INDEX, 0, spec);
    const World world = builder.build();
    Solver solver(gpu(), world);
    const double time = same.inertia / 20;
    run(solver, world, time);
    EXPECT_NEAR(speedOf(solver),
                3 * std::exp(-std::round(time / world.settings.timeStep) * world.settings.timeStep / time), 0.05);
}

/// Balls about any axis, universal joints about their two.
TEST(JointSpring, BallsAndUniversalJointsTurnBack)
{
    for (const JointType type : {JointType::Ball, JointType::Universal}) {
        WorldBuilder builder = makeBuilder(weightless());
        addBox(builder, {4, 4, 4}, {{0.6f, 0, 0}}, {0, 0, 0}, {type == JointType::Ball ? 1.0f : 0.0f, 1, 1});
        JointSpec spec;
        spec.type = type;
        spec.drive = spring(100, 20);
        builder.joinPlaced(NO_INDEX, 0, spec);
        const World world = builder.build();
        Solver solver(gpu(), world);
        run(solver, world, 0.2);
        const auto turned = [&] { return solver.readBodies()[0].rotation.angularDistance(Quaternionf::Identity()); };
        EXPECT_GT(turned(), 0.01);
        run(solver, world, 12);
        EXPECT_LT(turned(), 0.001);
    }
}

/// Slower than what falls asleep.
TEST(Motor, WhatItTurnsStaysAwake)
{
    Settings settings = weightless();
    settings.sleepSpeed = 0.1f;
    const Wheel wheel = wheelOn(speedMotor(0.05f, 10), settings);
    Solver solver(gpu(), wheel.world);
    run(solver, wheel.world, 3);
    EXPECT_NEAR(angleOf(solver), 0.15, 0.005);
}

/// A hundred thousand times what turns it in a substep, in both orders of time; beside a limit; under gravity.
TEST(Motor, NoStiffnessMakesItUnstable)
{
    for (const TurnDrive& drive : {speedMotor(3, 1e6f), angleMotor(0.5f, 1e6f), spring(1e9f, 0), spring(0, 1e9f)}) {
        const Wheel wheel = wheelOn(drive, {}, {-0.8f, 0, 0});
        Solver solver(gpu(), wheel.world);
        run(solver, wheel.world, 2);
        const BodyState body = solver.readBodies()[0];
        EXPECT_LT(body.angularVelocity.norm(), 3.1);
        EXPECT_NEAR((body.position - Vector3f(-0.8f, 0, 0)).norm(), 0.8, 0.01);
    }
}

}  // namespace knuckle::test
