#include <cmath>
#include <numbers>

#include "sim/rig/bodies/make_actor.h"
#include "sim/rig/clips/body_clip.h"
#include "sim/rig/clips/clip_ranges.h"
#include "sim/rig/joints/turn_parts.h"
#include "tests/physics/physics_fixture.h"
#include "tools/humanoid/humanoid.h"

namespace knuckle::test {

namespace {

constexpr float RATE = 60.0f;

constexpr uint32_t KEYS = 60, WILD = 30;

enum class Way { Bend, Cone, Twist };

/// A turn far beyond a joint's limits.
Quaternionf wildTurn(const ActorJoint& joint, Way way)
{
    if (way == Way::Bend) return Quaternionf(Eigen::AngleAxisf(joint.limits.bend.lowest - 80 * DEGREE, joint.axis));
    TurnReader reader(joint.limits, joint.type, joint.axis);
    TurnParts parts = reader.read(Quaternionf::Identity());
    if (way == Way::Cone) parts.swing = joint.limits.swing + 50 * DEGREE;
    else parts.twist = joint.limits.twist.highest + 80 * DEGREE;
    return reader.turnOf(parts);
}

/// At rest except for three keys.
BodyClip wildClip(const Actor& actor, const ActorJoint& joint, Way way)
{
    BodyClip clip{"wild", RATE, static_cast<uint32_t>(actor.bodies.size())};
    clip.roots.assign(KEYS, pivotOf(actor));
    clip.turns.assign(KEYS * actor.bodies.size(), Quaternionf::Identity());
    for (uint32_t key = WILD; key < WILD + 3; ++key)
        clip.turns[key * clip.bodyCount + joint.child] = wildTurn(joint, way);
    return clip;
}

/// The distance of a joint from its limits; below 0 beyond them [rad].
float roomOf(const World& world, const std::string& name, const std::vector<BodyState>& bodies)
{
    const Joint& joint = *std::ranges::find(world.joints, name, &Joint::name);
    const Quaternionf turn = (bodies[joint.parent].rotation * joint.parentSide.frame).conjugate() *
                             (bodies[joint.child].rotation * joint.childSide.frame);
    const float twist = turnAbout(Vector3f::UnitX(), turn);
    const float swing = std::acos(std::clamp((turn * Vector3f::UnitX()).x(), -1.0f, 1.0f));
    const TurnLimits& limits = joint.limits;
    const float room = limits.twist.bounded() ? std::min(twist - limits.twist.lowest, limits.twist.highest - twist) : 1;
    return limits.swing < std::numbers::pi_v<float> ? std::min(room, limits.swing - swing) : room;
}

}  // namespace

TEST(WildClip, LetGoInTheMidstOfAWildMomentItIsWithinLimitsAndGainsNoEnergy)
{
    const Actor made = makeActor(makeHumanoid(), {.name = {}, .voxels = {.diameter = 0.06f}, .articulation = {}});
    for (const auto& [name, way] : {std::pair("forearm.L", Way::Bend), std::pair("upper_arm.L", Way::Cone),
                                    std::pair("upper_arm.R", Way::Twist), std::pair("thigh.L", Way::Cone)}) {
        Actor actor = made;
        const auto joint = std::ranges::find(actor.joints, name, &ActorJoint::name);
        ASSERT_NE(joint, actor.joints.end());
        const JointLimits limits = joint->limits;
        BodyClip clip = wildClip(actor, *joint, way);
        EXPECT_FALSE(holdWithinLimits(actor, clip).empty());
        allow(actor, needsOf(actor, clip));
        EXPECT_NEAR(joint->limits.bend.lowest, limits.bend.lowest, 1e-3f) << name;
        EXPECT_NEAR(joint->limits.swing, limits.swing, 1e-3f) << name;
        EXPECT_NEAR(joint->limits.twist.highest, limits.twist.highest, 1e-3f) << name;

        for (const uint32_t key : {WILD - 1, WILD, WILD + 2}) {
            WorldBuilder builder(actor.diameter / 2);
            const uint32_t material = builder.addMaterial({});
            const float time = static_cast<float>(key) / RATE;
            const uint32_t object = addActor(builder, actor, material, {{0, 3, 0}, Quaternionf::Identity()});
            builder.animate(
                {object, {{0, 3, 0}, Quaternionf::Identity()}, pivotOf(actor), {{.clip = builder.addClip(clip)}}});
            for (uint32_t b = 0; b < actor.bodies.size(); ++b) builder.releaseBody(b, time);
            const World world = builder.build();
            Solver solver(gpu(), world);
            run(solver, world, time);
            EXPECT_GT(roomOf(world, name, solver.readBodies()), 0.0f) << name << ", key " << key;
            run(solver, world, world.settings.timeStep);
            const double start = energyOf(world, solver.readParticles());
            double highest = start;
            for (int step = 0; step < 30; ++step) {
                run(solver, world, world.settings.timeStep);
                highest = std::max(highest, energyOf(world, solver.readParticles()));
            }
            double mass = 0.0;
            for (const Particle& p : world.particles) mass += p.mass;
            EXPECT_LT(highest - start, 1e-3 * mass * GRAVITY) << name << ", key " << key << ": lifted by a millimetre";
        }
    }
}

}  // namespace knuckle::test
