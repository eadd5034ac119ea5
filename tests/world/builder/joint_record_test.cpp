#include <algorithm>
#include <set>

#include "tests/message_of.h"
#include "tests/world/world_fixture.h"

namespace knuckle::test {

namespace {

constexpr JointType TYPES[] = {JointType::Ball, JointType::Hinge, JointType::Stiff, JointType::Universal};

/// Two cubes with a free layer between them; their object is open.
WorldBuilder openPair()
{
    WorldBuilder builder = makeBuilder();
    builder.beginObject("pair");
    builder.addBody("a", cubeAt({-2, 0, 0}), 0);
    builder.addBody("b", cubeAt({2, 0, 0}), 0);
    return builder;
}

World closed(WorldBuilder& builder)
{
    builder.endObject();
    return builder.build();
}

World joinedPair(JointType type, const JointLimits& limits = {})
{
    WorldBuilder builder = openPair();
    JointSpec spec;
    spec.type = type;
    spec.name = "joint";
    spec.limits = limits;
    builder.addJoint(0, 1, spec);
    return closed(builder);
}

std::set<uint32_t> particlesOf(const World& world, uint32_t body)
{
    std::set<uint32_t> particles;
    for (const Link& link : world.links)
        if (link.body == body) particles.insert(link.particle);
    return particles;
}

}  // namespace

TEST(JointRecord, SaysWhatTheLinksSay)
{
    for (const JointType type : TYPES) {
        const World world = joinedPair(type);
        SCOPED_TRACE(jointTypeName(type));
        ASSERT_EQ(world.joints.size(), type == JointType::Universal ? 2u : 1u);
        for (const Joint& joint : world.joints) {
            const std::set<uint32_t> ofParent = particlesOf(world, joint.parent),
                                     ofChild = particlesOf(world, joint.child);
            std::vector<uint32_t> shared;
            std::ranges::set_intersection(ofParent, ofChild, std::back_inserter(shared));
            EXPECT_EQ(joint.particles, shared);
            EXPECT_EQ(joint.type, type == JointType::Universal ? JointType::Hinge : type);
        }
    }
}

TEST(JointRecord, BothSidesAgreeAtRest)
{
    for (const JointType type : TYPES) {
        const World world = joinedPair(type);
        for (const Joint& joint : world.joints) {
            const Vector3f parent = world.bodies[joint.parent].restCentre + joint.parentSide.arm;
            const Vector3f child = world.bodies[joint.child].restCentre + joint.childSide.arm;
            // Sums of a few dozen floats of some decimetres.
            EXPECT_LT((parent - child).norm(), 1e-7f) << jointTypeName(type);
            EXPECT_LT(parent.norm(), 1e-7f) << "where the joint was put";
            // The acos in angularDistance turns a rounding error into its root.
            EXPECT_LT(joint.parentSide.frame.angularDistance(joint.childSide.frame), 1e-3f) << jointTypeName(type);
        }
    }
}

TEST(JointRecord, ItsFramesAreWhereItsLimitsAre)
{
    JointLimits limits;
    limits.swing = 0.5f;
    limits.cone = {1, 0.2f, 0};
    const Joint joint = joinedPair(JointType::Ball, limits).joints.at(0);
    EXPECT_EQ(joint.limits.swing, 0.5f);
    EXPECT_LT((joint.childSide.frame * Vector3f::UnitX() - Vector3f(1, 0, 0)).norm(), 1e-6f);
    EXPECT_LT((joint.parentSide.frame * Vector3f::UnitX() - limits.cone.normalized()).norm(), 1e-6f);
}

TEST(JointRecord, WhatIsSharedWithoutAWordIsRecordedToo)
{
    WorldBuilder builder = openPair();
    builder.shareParticle(5, 1);
    builder.shareParticle(7, 1);
    const World world = closed(builder);
    ASSERT_EQ(world.joints.size(), 1u);
    EXPECT_EQ(world.joints[0].particles, (std::vector<uint32_t>{5, 7}));
    EXPECT_EQ(world.joints[0].type, JointType::Hinge) << "two places are an axis";
    EXPECT_EQ(world.joints[0].name, "a-b");
}

TEST(JointRecord, AParticleOfThreeBodiesHasTwoJoints)
{
    WorldBuilder builder = openPair();
    builder.addBody("c", cubeAt({0, 4, 0}), 0);
    builder.shareParticle(5, 1);
    builder.shareParticle(5, 2);
    const World world = closed(builder);
    ASSERT_EQ(world.joints.size(), 2u);
    for (const Joint& joint : world.joints) EXPECT_EQ(joint.particles, std::vector<uint32_t>{5});
}

TEST(JointRecord, TwoJointsOfOnePairAreOne)
{
    WorldBuilder builder = openPair();
    JointSpec spec;
    spec.strength.force = 70.0f;
    spec.anchor = {0, 0, -DIAMETER};
    builder.addJoint(0, 1, spec);
    spec.strength.force = 50.0f;
    spec.anchor = {0, 0, DIAMETER};
    builder.addJoint(1, 0, spec);
    const World world = closed(builder);
    ASSERT_EQ(world.joints.size(), 1u);
    EXPECT_EQ(world.joints[0].type, JointType::Hinge);
    EXPECT_EQ(world.joints[0].strength.force, 50.0f);
}

TEST(JointRecord, AWorldWhoseRecordsAreWrongIsRefused)
{
    const World good = joinedPair(JointType::Hinge);
    World world = good;
    world.joints[0].particles.erase(world.joints[0].particles.begin());
    EXPECT_EQ(misuseOf([&] { validate(world); }),
              "particle " + std::to_string(good.joints[0].particles[0]) + " is shared without a joint");
    world = good;
    world.joints[0].particles = {0};
    EXPECT_EQ(misuseOf([&] { validate(world); }), "the joint \"joint\": its particles must belong to both bodies");
    world = good;
    world.joints[0].child = world.joints[0].parent;
    EXPECT_EQ(misuseOf([&] { validate(world); }), "the joint \"joint\": it needs two different bodies that exist");
    world = good;
    world.joints[0].childSide.frame.coeffs().setZero();
    EXPECT_EQ(misuseOf([&] { validate(world); }), "the joint \"joint\": its arms and frames must be finite");
}

}  // namespace knuckle::test
