#include "sim/base/errors.h"
#include "tests/rig/actor_fixture.h"
#include "tools/humanoid/humanoid.h"

namespace knuckle {
namespace {

void expectOnAxis(const Actor& actor, const ActorJoint& joint)
{
    ASSERT_GE(joint.sharedParticles.size(), 2u);
    for (uint32_t particle : joint.sharedParticles) {
        const Vector3f offset = actor.particles[particle] - joint.anchor;
        EXPECT_LT((offset - offset.dot(joint.axis) * joint.axis).norm(), 1e-5f) << joint.name;
    }
}

TEST(Articulate, humanoidBecomesATreeAtEveryDiameter)
{
    for (const float diameter : {0.08f, 0.05f, 0.04f, 0.03f, 0.02f}) {
        const Actor actor = make(makeHumanoid(), diameter);
        expectSound(actor);
        EXPECT_EQ(actor.diameter, diameter);
    }
    EXPECT_GE(make(makeHumanoid(), 0.04f).bodies.size(), 17u);
}

TEST(Articulate, jointsSitAtTheHeadsOfTheirBones)
{
    const Model model = makeHumanoid();
    for (const ActorJoint& joint : make(model, 0.04f).joints) {
        const auto bone = std::find_if(model.bones.begin(), model.bones.end(),
                                       [&](const Bone& b) { return b.name == joint.name; });
        ASSERT_NE(bone, model.bones.end());
        EXPECT_LT((joint.anchor - bone->restPose.block<3, 1>(0, 3)).norm(), 1e-5f) << joint.name;
    }
}

TEST(Articulate, kneesAndElbowsAreHingesWithTheirParticlesOnOneLine)
{
    const Actor actor = make(makeHumanoid(), 0.03f);
    int hinges = 0;
    for (const ActorJoint& joint : actor.joints) {
        if (joint.type == JointType::Hinge) {
            ++hinges;
            expectOnAxis(actor, joint);
        }
    }
    EXPECT_EQ(hinges, 4);
}

TEST(Articulate, kneesTurnAboutTheAxisFromLeftToRight)
{
    for (const ActorJoint& joint : make(makeHumanoid(), 0.04f).joints) {
        if (joint.name.starts_with("shin")) {
            EXPECT_GT(std::abs(joint.axis.x()), 0.95f);
        }
    }
}

TEST(Articulate, kneesHaveRoomBehindAndNoneInFront)
{
    ArticulationOptions options;
    options.limited = false;  // with limits a thigh and a shin may overlap
    const Actor actor = make(makeHumanoid(), 0.03f, options);
    for (const ActorJoint& joint : actor.joints) {
        if (!joint.name.starts_with("shin")) {
            continue;
        }
        size_t behind = 0, front = 0;
        for (const uint32_t body : {joint.parent, joint.child}) {
            for (const uint32_t particle : actor.bodies[body].particles) {
                const Vector3f offset = actor.particles[particle] - joint.anchor;
                const bool atKnee = std::abs(offset.y()) < 0.6f * actor.diameter;
                behind += atKnee && offset.z() < -0.8f * actor.diameter;
                front += atKnee && offset.z() > 0.5f * actor.diameter;
            }
        }
        EXPECT_EQ(behind, 0u);
        EXPECT_GT(front, 0u);
    }
}

TEST(Articulate, numbersParticlesAsAWorldDoes)
{
    const Actor actor = make(makeHumanoid(), 0.05f);
    WorldBuilder builder(0.5f * actor.diameter);
    addActor(builder, actor, builder.addMaterial({}), {});
    const World world = builder.build();
    ASSERT_EQ(world.particles.size(), actor.particles.size());
    for (size_t p = 0; p < world.particles.size(); ++p)
        EXPECT_LT((world.particles[p].position - actor.particles[p]).norm(), 1e-5f) << p;
    for (uint32_t b = 0; b < actor.bodies.size(); ++b)
        for (uint32_t i = 0; i < world.bodies[b].linkCount; ++i)
            EXPECT_TRUE(contains(actor.bodies[b].particles, world.links[world.bodies[b].linkStart + i].particle));
}

TEST(Articulate, ballSharesOneParticleAtTheAnchor)
{
    const Actor actor = make(twoBoneBox("something"), 0.1f);
    expectSound(actor);
    ASSERT_EQ(actor.joints.size(), 1u);
    EXPECT_EQ(actor.joints[0].type, JointType::Ball);
    ASSERT_EQ(actor.joints[0].sharedParticles.size(), 1u);
    EXPECT_LT((actor.particles[actor.joints[0].sharedParticles[0]] - Vector3f(0, 0, 1)).norm(), 1e-6f);
}

TEST(Articulate, stiffSharesFourParticlesThatSpanAPlane)
{
    ArticulationOptions options;
    options.limited = false;
    const Actor actor = make(twoBoneBox("spine"), 0.1f, options);
    expectSound(actor);
    const auto& shared = actor.joints.at(0).sharedParticles;
    ASSERT_EQ(std::set<uint32_t>(shared.begin(), shared.end()).size(), 4u);
    const Vector3f a = actor.particles[shared[0]];
    float area = 0.0f;
    for (uint32_t p : shared) {
        area = std::max(area, (actor.particles[p] - a).cross(actor.particles[shared[1]] - a).norm());
    }
    EXPECT_GT(area, actor.diameter * actor.diameter);
}

TEST(Articulate, universalPutsAFlatBodyBetweenTwoCrossedHinges)
{
    ArticulationOptions options;
    options.types["tip"] = JointType::Universal;
    const Actor actor = make(twoBoneBox("tip"), 0.1f, options);
    expectSound(actor);
    ASSERT_EQ(actor.bodies.size(), 3u);
    ASSERT_EQ(actor.joints.size(), 2u);
    const ActorBody& cross = actor.bodies[actor.joints[0].child];
    EXPECT_EQ(cross.name, "tip/cross");
    EXPECT_EQ(cross.particles.size(), 5u);
    EXPECT_NEAR(actor.joints[0].axis.dot(actor.joints[1].axis), 0.0f, 1e-6f);
    for (const ActorJoint& joint : actor.joints) {
        EXPECT_EQ(joint.type, JointType::Universal);
        EXPECT_EQ(joint.sharedParticles.size(), 2u);
        expectOnAxis(actor, joint);
    }
}

TEST(Articulate, overriddenAxisIsKept)
{
    ArticulationOptions options;
    options.types["tip"] = JointType::Hinge;
    options.axes["tip"] = {0, 2, 0};
    const Actor actor = make(twoBoneBox("tip"), 0.1f, options);
    EXPECT_EQ(actor.joints.at(0).axis, Vector3f(0, 1, 0));
    expectOnAxis(actor, actor.joints[0]);
}

TEST(Articulate, overridesMayBePatterns)
{
    ArticulationOptions options;
    options.types["*"] = JointType::Stiff;
    options.types["t?p"] = JointType::Hinge;
    options.axes["ti*"] = {0, 2, 0};
    const Actor actor = make(twoBoneBox("tip"), 0.1f, options);
    EXPECT_EQ(actor.joints.at(0).type, JointType::Hinge);
    EXPECT_EQ(actor.joints.at(0).axis, Vector3f(0, 1, 0));
}

TEST(Articulate, overrideForABoneThatIsNotThereIsRefused)
{
    ArticulationOptions options;
    options.types["wing"] = JointType::Ball;
    EXPECT_THROW(make(twoBoneBox("tip"), 0.1f, options), InputError);
}

TEST(Articulate, twoRunsGiveTheSameActor)
{
    const Actor a = make(makeHumanoid(), 0.03f), b = make(makeHumanoid(), 0.03f);
    EXPECT_EQ(a.particles, b.particles);
    ASSERT_EQ(a.bodies.size(), b.bodies.size());
    for (size_t i = 0; i < a.bodies.size(); ++i) {
        EXPECT_EQ(a.bodies[i].particles, b.bodies[i].particles);
    }
}

TEST(Articulate, worldBuiltFromAnActorHasItsBodiesAndSharedParticles)
{
    const Actor actor = make(makeHumanoid(), 0.05f);
    WorldBuilder builder(0.5f * actor.diameter);
    const uint32_t material = builder.addMaterial({});
    addActor(builder, actor, material, {{0, 3, 0}, Quaternionf::Identity()}, {1, 0, 0});
    const World world = builder.build();
    EXPECT_EQ(world.particles.size(), actor.particles.size());
    ASSERT_EQ(world.bodies.size(), actor.bodies.size());
    size_t links = 0, shared = 0;
    for (size_t b = 0; b < actor.bodies.size(); ++b) {
        EXPECT_EQ(world.bodies[b].linkCount, actor.bodies[b].particles.size()) << actor.bodies[b].name;
        links += actor.bodies[b].particles.size();
    }
    EXPECT_EQ(world.links.size(), links);
    for (const Particle& particle : world.particles) {
        shared += particle.bodyCount - 1;
    }
    EXPECT_EQ(shared, links - actor.particles.size());
    EXPECT_EQ(world.assemblyCount, 1u);
}

TEST(Articulate, jointThatHardlyTurnsIsStiff)
{
    ArticulationOptions options;
    options.types["upper"] = JointType::Hinge;
    options.limits["upper"].bend = {-0.03f, 0.03f};
    const Actor actor = make(twoBoneBox("upper"), 0.1f, options);
    EXPECT_EQ(actor.joints.front().type, JointType::Stiff);
    EXPECT_FALSE(actor.joints.front().limits.any());
    EXPECT_EQ(actor.joints.front().sharedParticles.size(), 4u);
}

}  // namespace

}  // namespace knuckle
