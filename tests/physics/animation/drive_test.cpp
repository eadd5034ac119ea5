#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "tests/physics/physics_fixture.h"

namespace knuckle::test {

namespace {

constexpr double PI = std::numbers::pi;

/// Two cubes on a hinge along z: the first is animated for ever, the second driven from the start.
struct Limb {
    Settings settings;
    DriveSpring spring;
    float density = 1000.0f;
    float target = 0.0f;  ///< Of the hinge [rad] ...
    float later = 0.0f;   ///< ... and from `at` on.
    float at = 1e6f;      ///< [s]
    bool parentFree = false;
    JointType type = JointType::Hinge;
    float pin = 0.0f;  ///< Frequency of the parent's pin [Hz].

    World world() const;
};

BodyClip still(float angle)
{
    const Quaternionf turned(Eigen::AngleAxisf(angle, Vector3f::UnitZ()));
    return {"still", 60.0f, 2, {Vector3f::Zero()}, {Quaternionf::Identity(), turned}};
}

World Limb::world() const
{
    WorldBuilder builder = makeBuilder(settings);
    Material heavy;
    heavy.density = density;
    const uint32_t material = builder.addMaterial(heavy);
    builder.beginObject("limb");
    const auto cube = [&](float x, uint32_t made) {
        std::vector<Vector3f> places = boxLattice({3, 3, 3}, DIAMETER);
        for (Vector3f& p : places) p.x() += x;
        return builder.addBody(x == 0.0f ? "parent" : "limb", places, made);
    };
    const uint32_t a = cube(0, material), b = cube(4 * DIAMETER, material);
    JointSpec joint;
    joint.type = type;
    joint.anchor = {2 * DIAMETER, 0, 0};
    builder.addJoint(a, b, joint);
    Animation animation;
    animation.object = builder.endObject({{0, 3, 0}, Quaternionf::Identity()});
    animation.plays = {{.clip = builder.addClip(still(target))}, {.clip = builder.addClip(still(later)), .at = at}};
    builder.animate(animation);
    builder.releaseBody(b, 0.0f);
    if (parentFree) builder.releaseBody(a, 0.0f);
    Puppet puppet;
    puppet.joints = {spring, spring};
    puppet.limpTimes.assign(2, DriveSpring::INFINITE);
    if (pin > 0.0f) puppet.pins = {{0, {.frequency = pin}}};
    builder.drive(puppet);
    return builder.build();
}

/// The hinge's angle [rad].
double angleOf(Solver& solver)
{
    const std::vector<BodyState> bodies = solver.readBodies();
    const Quaternionf turn = bodies[0].rotation.conjugate() * bodies[1].rotation;
    return 2.0 * std::atan2(turn.z(), turn.w());
}

/// A limb's data about the hinge: mass times arm [kg m], inertia [kg m2].
struct Lever {
    double moment = 0.0, inertia = 0.0;
};

Lever leverOf(const World& world)
{
    Lever lever;
    const Body& limb = world.bodies[1];
    for (uint32_t k = 0; k < limb.linkCount; ++k) {
        const Link& link = world.links[limb.linkStart + k];
        const Eigen::Vector3d r = (limb.restCentre + link.restOffset - Vector3f(2 * DIAMETER, 0, 0)).cast<double>();
        lever.moment += double{link.mass} * r.x();
        lever.inertia += double{link.mass} * (r.x() * r.x() + r.y() * r.y());
    }
    return lever;
}

/// Response to a step of the target's angle: when the limb passes its new target, and its largest distance from it in
/// between.
struct Ringing {
    std::vector<double> crossings, extremes;
};

Ringing ring(const Limb& limb, int periods)
{
    const World world = limb.world();
    Solver solver(gpu(), world);
    Ringing ringing;
    run(solver, world, limb.at);
    double before = angleOf(solver) - limb.later, extreme = 0.0;
    const int steps = static_cast<int>(static_cast<float>(periods) / limb.spring.frequency / world.settings.timeStep);
    for (int i = 0; i < steps; ++i) {
        run(solver, world, world.settings.timeStep);
        const double now = angleOf(solver) - limb.later;
        if (now * before < 0.0) {
            ringing.crossings.push_back((i + before / (before - now)) * world.settings.timeStep);
            ringing.extremes.push_back(extreme);
            extreme = 0.0;
        }
        extreme = std::max(extreme, std::abs(now));
        before = now;
    }
    return ringing;
}

DriveSpring given(float stiffness, float damping)
{
    DriveSpring spring;
    spring.stiffness = stiffness;
    spring.damping = damping;
    return spring;
}

}  // namespace

/// Gravity turns a level limb until its spring holds it: k angle = m g arm cos(angle).
TEST(Drive, HoldsALimbWhereStaticsHasIt)
{
    for (const float density : {1000.0f / 27, 100000.0f / 27})
        for (const uint32_t substeps : {4u, 16u})
            for (const JointType type : {JointType::Hinge, JointType::Ball}) {
                Limb limb{.settings = {}, .spring = {.frequency = 1.5f}, .density = density, .type = type};
                limb.settings.substeps = substeps;
                const World world = limb.world();
                Solver solver(gpu(), world);
                run(solver, world, 4.0);
                const Lever lever = leverOf(world);
                const double stiffness = std::pow(2 * PI * 1.5, 2) * lever.inertia;
                double wanted = 0.0;
                for (int i = 0; i < 100; ++i) wanted = lever.moment * GRAVITY * std::cos(wanted) / stiffness;
                // After 37 rad of a spring without overshoot, nothing is left of the swing.
                EXPECT_NEAR(-angleOf(solver), wanted, 0.005 * wanted) << density << " " << substeps;
            }
}

/// A damped spring that includes the target's speed: it passes the new target and comes back.
TEST(Drive, RingsAtItsFrequencyAndDamping)
{
    for (const bool parentFree : {false, true})
        for (const float frequency : {1.0f, 4.0f, 10.0f}) {
            const double ratio = 0.1;
            Limb limb{.settings = weightless(), .spring = {.frequency = frequency, .dampingRatio = 0.1f}};
            limb.later = 0.2f;
            limb.at = 0.5f;
            limb.parentFree = parentFree;
            limb.settings.timeStep = 1.0f / 240;
            limb.settings.substeps = 2;
            const Ringing ringing = ring(limb, 5);
            ASSERT_GE(ringing.crossings.size(), 6u) << frequency;
            const double period = (ringing.crossings[5] - ringing.crossings[1]) / 2;
            const double natural = 1 / (period * std::sqrt(1 - ratio * ratio));
            const double decrement = std::log(ringing.extremes[2] / ringing.extremes[4]);
            const double damped = decrement / std::hypot(2 * PI, decrement);
            // BDF2 with w h = 0.13 at 10 Hz: its period is off by (w h)^2, 1.7 %.
            EXPECT_NEAR(natural, double{frequency}, 0.02 * double{frequency}) << parentFree;
            EXPECT_NEAR(damped, ratio, 0.05 * ratio) << frequency << " " << parentFree;
        }
}

/// A limb that has to turn by half a turn, with its greatest torque T all the way: T t^2 / (2 inertia).
TEST(Drive, TurnsNoHarderThanItMay)
{
    Limb limb{.settings = weightless(), .spring = {.frequency = 10.0f, .greatestTorque = 2.0f}};
    limb.later = 3.0f;
    limb.at = 0.1f;
    const World world = limb.world();
    Solver solver(gpu(), world);
    run(solver, world, 0.1);
    const double inertia = leverOf(world).inertia, seconds = std::sqrt(2 * 0.5 * inertia / 2.0);
    const double steps = std::floor(seconds / world.settings.timeStep), t = steps * world.settings.timeStep;
    run(solver, world, t);
    // The target jumps within the first substep, which may be over or not: t is known within one, 2 / (8 steps).
    EXPECT_NEAR(angleOf(solver), t * t / inertia, 0.02 * t * t / inertia);
}

/// No strength, load or substep makes it swing: a limb of a ton on a joint of 1e8 N m/rad stays at its target.
TEST(Drive, IsStableHoweverStiff)
{
    for (const float stiffness : {1e3f, 1e5f, 1e8f})
        for (const float density : {37.0f, 37000.0f})
            for (const uint32_t substeps : {1u, 4u, 16u}) {
                Limb limb{.settings = {}, .spring = given(stiffness, 0.1f * stiffness), .density = density};
                limb.settings.substeps = substeps;
                limb.target = 0.3f;
                limb.later = -0.4f;
                limb.at = 1.0f;
                const World world = limb.world();
                Solver solver(gpu(), world);
                run(solver, world, 0.9);
                const Lever lever = leverOf(world);
                const double most = lever.moment * GRAVITY / double{stiffness};
                if (most > 0.2) continue;  // it hangs down
                // The spring gives way by the weight's moment over its stiffness; single precision adds 1e-4 rad.
                EXPECT_NEAR(angleOf(solver), 0.3, most + 1e-4) << stiffness << " " << density << " " << substeps;
                run(solver, world, 2.1);
                EXPECT_NEAR(angleOf(solver), -0.4, most + 1e-3) << stiffness << " " << density << " " << substeps;
            }
}

/// A pinned body hangs below its place by the weight of all that it holds: g / (2 pi f)^2.
TEST(Drive, APinHoldsWhatHangsOnIt)
{
    Limb limb{.settings = {}, .spring = {.frequency = 5.0f}};
    limb.parentFree = true;
    limb.pin = 2.0f;
    const World world = limb.world();
    Solver solver(gpu(), world);
    run(solver, world, 4.0);
    const double wanted = GRAVITY / std::pow(2 * PI * 2.0, 2);
    EXPECT_NEAR(-double{solver.readBodies()[0].position.y()}, wanted, 0.01 * wanted);
}

}  // namespace knuckle::test
