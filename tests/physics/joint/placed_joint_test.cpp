#include <cmath>

#include "tests/physics/physics_fixture.h"

namespace knuckle::test {

namespace {

/// A hinge along z.
JointSpec hingeAt(const Vector3f& anchor)
{
    JointSpec spec;
    spec.type = JointType::Hinge;
    spec.name = "hinge";
    spec.anchor = anchor;
    return spec;
}

/// A turn about z after another about an axis askew, so that a body's axes are not the world's.
Quaternionf turned(float angle, const Quaternionf& before)
{
    return Quaternionf(Eigen::AngleAxisf(angle, Vector3f::UnitZ())) * before;
}

const Quaternionf ON_ITS_SIDE{std::sqrt(0.5f), 0, std::sqrt(0.5f), 0};  // x to -z

}  // namespace

/// 3 x 3 x 10 particles, whose long edge z is put along x and then hangs down, swung by 0.1 rad about (1, 2, 0).
TEST(PlacedJoint, ADoorSwingsAboutTheWorldAsItsInertiaSays)
{
    WorldBuilder builder = makeBuilder();
    const Vector3f hinge(1, 2, 0), fromHinge(0.5f, 0, 0);
    const Quaternionf rotation = turned(-1.5708f + 0.1f, ON_ITS_SIDE);
    const Quaternionf lean(Eigen::AngleAxisf(-1.5708f + 0.1f, Vector3f::UnitZ()));
    addBox(builder, {3, 3, 10}, {hinge + lean * fromHinge, rotation});
    builder.joinPlaced(NO_INDEX, 0, hingeAt(hinge));
    const World world = builder.build();
    ASSERT_EQ(world.joints.size(), 1u);
    EXPECT_EQ(world.joints[0].type, JointType::Hinge);
    // The axis is the body's x, and the hinge half a metre from its centre along z.
    double inertia = 0, moment = 0;
    for (const Link& link : world.links) {
        if (link.body != 0) continue;
        const Vector3f arm = link.restOffset + world.bodies[0].restCentre;
        const double along = 0.5 - std::copysign(1.0f, (rotation * Vector3f::UnitZ()).dot(Vector3f::UnitY())) * arm.z();
        inertia += link.mass * (along * along + arm.y() * arm.y());
        moment += link.mass * along;
    }
    const double period = 2 * M_PI * std::sqrt(inertia / moment / GRAVITY) * (1 + 0.1 * 0.1 / 16);
    Solver solver(gpu(), world);
    std::vector<double> crossings;
    const double h = world.settings.timeStep;
    double last = 0.1;
    for (int i = 1; i * h < 5.6 * period; ++i) {
        run(solver, world, h);
        const double x = solver.readBodies()[0].position.x() - hinge.x();
        if (last > 0 && x <= 0) crossings.push_back((i - 1 + last / (last - x)) * h);
        last = x;
    }
    ASSERT_GE(crossings.size(), 5u);
    EXPECT_NEAR((crossings[4] - crossings[0]) / 4, period, 0.01 * period);
}

/// A cube of 27 kg on a ball joint of the world, whose strength is its weight and a tenth more or less.
TEST(PlacedJoint, BearsTheWeightThatHangsOnIt)
{
    for (const bool holds : {true, false}) {
        WorldBuilder builder = makeBuilder();
        addBox(builder, {3, 3, 3}, {{0, 1, 0}, ON_ITS_SIDE});
        JointSpec spec = hingeAt({0, 1.2f, 0});
        spec.type = JointType::Ball;
        spec.strength.force = (holds ? 1.1f : 0.9f) * 27.0f * static_cast<float>(GRAVITY);
        builder.joinPlaced(NO_INDEX, 0, spec);
        const World world = builder.build();
        Solver solver(gpu(), world);
        run(solver, world, 0.5);
        const float fallen = 1.0f - solver.readBodies()[0].position.y();
        if (holds) EXPECT_LT(std::abs(fallen), 0.001f);
        else EXPECT_GT(fallen, 0.8f);
    }
}

/// A bar between the world and a load of a thousand times its mass, let go level; the bar stops after 30 degrees.
TEST(PlacedJoint, HoldsItsLimitUnderAThousandTimesTheWeight)
{
    WorldBuilder builder = makeBuilder();
    Material heavy = builder.material(0);
    heavy.density = 1e5f;
    Material light = builder.material(0);
    light.density = 90;
    const uint32_t load = builder.addMaterial(heavy), bar = builder.addMaterial(light);
    builder.beginObject("bar");
    builder.addBody("bar", boxLattice({10, 1, 1}, DIAMETER), bar);
    builder.endObject({{0.6f, 0, 0}, {0, 1, 0, 0}});
    builder.beginObject("load");
    builder.addBody("load", boxLattice({3, 1, 3}, DIAMETER), load);
    builder.endObject({{1.2f, -0.2f, 0}, ON_ITS_SIDE});
    JointSpec limited = hingeAt({0, 0, 0});
    limited.limits.bend = {-0.5236f, 0.5236f};
    builder.joinPlaced(NO_INDEX, 0, limited);
    JointSpec stiff = hingeAt({1.2f, 0, 0});
    stiff.type = JointType::Ball;
    builder.joinPlaced(0, 1, stiff);
    const World world = builder.build();
    EXPECT_GT(world.bodies[1].mass, 990 * world.bodies[0].mass);
    Solver solver(gpu(), world);
    run(solver, world, 3.0);
    const std::vector<BodyState> bodies = solver.readBodies();
    const double angle = std::atan2(bodies[0].position.y(), bodies[0].position.x()) * 180 / M_PI;
    EXPECT_NEAR(angle, -30, 1);
    EXPECT_LT(solver.measure().worstJointGap, 0.05f * DIAMETER);
}

/// Two cubes, 27 kg at 0.4 m and 54 kg at 0.2 m, on a plank over a hinge of the world.
TEST(PlacedJoint, ASeesawIsLevelWhereItsMomentsAreEqual)
{
    WorldBuilder builder = makeBuilder();
    Material twice = builder.material(0);
    twice.density = 2000;
    const uint32_t heavy = builder.addMaterial(twice);
    addBox(builder, {11, 1, 3}, {{0, 1, 0}});
    addBox(builder, {3, 3, 3}, {{-0.4f, 1.2f, 0}});
    builder.beginObject("heavy");
    builder.addBody("heavy", boxLattice({3, 3, 3}, DIAMETER), heavy);
    builder.endObject({{0.2f, 1.2f, 0}, ON_ITS_SIDE});
    builder.joinPlaced(NO_INDEX, 0, hingeAt({0, 1.0f, 0}));
    JointSpec stiff = hingeAt({-0.4f, 1.1f, 0});
    stiff.type = JointType::Stiff;
    builder.joinPlaced(0, 1, stiff);
    stiff.anchor = {0.2f, 1.1f, 0};
    builder.joinPlaced(0, 2, stiff);
    const World world = builder.build();
    Solver solver(gpu(), world);
    run(solver, world, 0.25);
    // Its centre is above the hinge: it leaves the level slowly. A moment of a tenth of one cube's would turn it by
    // 0.5 * 10.6 N m / 17 kg m2 * (0.25 s)^2, 0.02 rad.
    const Vector3f along = solver.readBodies()[0].rotation * Vector3f::UnitX();
    EXPECT_NEAR(along.y(), 0, 0.004f);
}

}  // namespace knuckle::test
