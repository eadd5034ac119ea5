#include "sim/solver/layout/joint_trees.h"

#include <algorithm>

#include "shared/constants.h"
#include "tests/solver/joint/joined_world.h"
#include "tests/solver/solver_test.h"

namespace knuckle::test {

namespace {

/// Checks properties of every tree: parents come before children, the children of a body are together.
void expectTrees(const JointTrees& trees)
{
    std::vector<uint32_t> timesChild(trees.joints.size());
    uint32_t next = 0;
    for (const JointTrees::Tree& tree : trees.trees) {
        EXPECT_EQ(trees.joints[tree.first].parentJoint, NO_INDEX);
        for (uint32_t k = tree.first; k < tree.end; ++k) {
            const JointTrees::Joint& joint = trees.joints[k];
            EXPECT_EQ(joint.bodyJoint, k);
            if (k > tree.first) {
                ASSERT_LT(joint.parentJoint, k);
                EXPECT_GE(joint.parentJoint, tree.first);
                EXPECT_EQ(trees.joints[joint.parentJoint].body, joint.parent);
            }
            for (uint32_t child = joint.firstChild; child < joint.childEnd; ++child) {
                EXPECT_EQ(trees.joints.at(child).parentJoint, k);
                ++timesChild[child];
            }
        }
        next += tree.end - tree.first;
    }
    EXPECT_EQ(next, trees.joints.size());
    for (const JointTrees::Tree& tree : trees.trees)
        for (uint32_t k = tree.first; k < tree.end; ++k) EXPECT_EQ(timesChild[k], k > tree.first ? 1u : 0u);
}

const JointTrees::Joint& jointOf(const JointTrees& trees, uint32_t body)
{
    return *std::ranges::find(trees.joints, body, &JointTrees::Joint::body);
}

Vector3f place(const World& world, uint32_t body, const Vector3f& arm)
{
    return world.bodies[body].position + world.bodies[body].rotation * arm;
}

/// Checks that a joint's two sides agree in the rest pose, in place and in axes.
void expectAtRest(const World& world, const JointTrees::Joint& joint)
{
    const Vector3f own = place(world, joint.body, joint.side.arm),
                   other = place(world, joint.parent, joint.parentSide.arm);
    EXPECT_LT((own - other).norm(), 1e-6f) << "body " << joint.body;
    const Quaternionf frame = world.bodies[joint.body].rotation * joint.side.frame;
    const Quaternionf parentFrame = world.bodies[joint.parent].rotation * joint.parentSide.frame;
    // The acos in angularDistance turns a rounding error into its root.
    EXPECT_LT(frame.angularDistance(parentFrame), 2e-3f) << "body " << joint.body;
}

}  // namespace

TEST(JointTrees, ABranchedFigureIsOneTree)
{
    const World world = branchedWorld();
    const JointTrees trees(world);
    expectTrees(trees);
    ASSERT_EQ(trees.trees.size(), 2u);
    // The cross of the universal joint is a body of its own, and the body alone belongs to no tree.
    EXPECT_EQ(trees.trees[0].end - trees.trees[0].first, 7u) << "the largest first";
    EXPECT_EQ(trees.trees[1].end - trees.trees[1].first, 2u);
    EXPECT_TRUE(trees.loops.empty());
    for (const JointTrees::Joint& joint : trees.joints)
        if (joint.parent != NO_INDEX) expectAtRest(world, joint);
}

TEST(JointTrees, WhatParticlesShareTellsHowAJointLetsGo)
{
    const JointTrees trees(branchedWorld());
    const auto freedomBetween = [&](uint32_t a, uint32_t b) {
        const JointTrees::Joint& joint = jointOf(trees, b).parent == a ? jointOf(trees, b) : jointOf(trees, a);
        EXPECT_TRUE(joint.parent == a || joint.parent == b);
        return joint.freedom;
    };
    EXPECT_EQ(freedomBetween(2, 1), JOINT_BALL);
    EXPECT_EQ(freedomBetween(2, 3), JOINT_HINGE);
    EXPECT_EQ(freedomBetween(3, 4), JOINT_STIFF);
    EXPECT_EQ(freedomBetween(3, 5), JOINT_BALL);
    EXPECT_EQ(freedomBetween(6, 7), JOINT_HINGE);
}

TEST(JointTrees, AHingeTurnsAboutItsLine)
{
    const World world = branchedWorld();
    const JointTrees trees(world);
    const JointTrees::Joint& hinge = jointOf(trees, 7);
    const Vector3f axis = world.bodies[7].rotation * (hinge.side.frame * Vector3f::UnitX());
    EXPECT_NEAR(std::abs(axis.z()), 1.0f, 1e-5f);
}

TEST(JointTrees, AUniversalJointIsTwoHingesAboutItsCross)
{
    const World world = branchedWorld();
    const JointTrees trees(world);
    uint32_t hinges = 0;
    for (const JointTrees::Joint& joint : trees.joints) {
        if (joint.parent == NO_INDEX) continue;
        const bool crossed = world.bodies[joint.body].isCross || world.bodies[joint.parent].isCross;
        hinges += crossed && joint.freedom == JOINT_HINGE;
    }
    EXPECT_EQ(hinges, 2u);
}

TEST(JointTrees, AFixedBodyHoldsATreeAndBelongsToNone)
{
    const JointTrees trees(branchedWorld());
    const JointTrees::Joint& held = jointOf(trees, 7);
    EXPECT_EQ(held.parent, 6u);
    EXPECT_EQ(held.parentJoint, NO_INDEX);
    EXPECT_EQ(std::ranges::find(trees.joints, 6u, &JointTrees::Joint::body), trees.joints.end());
}

TEST(JointTrees, ATreeThatNothingHoldsHasARootWithoutAParent)
{
    const JointTrees trees(branchedWorld());
    const JointTrees::Joint& root = trees.joints[trees.trees[0].first];
    EXPECT_EQ(root.parent, NO_INDEX);
    EXPECT_EQ(root.freedom, JOINT_NONE);
}

TEST(JointTrees, ARingIsATreeAndOneLoop)
{
    const World world = ringWorld();
    const JointTrees trees(world);
    expectTrees(trees);
    ASSERT_EQ(trees.trees.size(), 1u);
    ASSERT_EQ(trees.loops.size(), 1u);
    EXPECT_EQ(trees.trees[0].firstLoop, 0u);
    EXPECT_EQ(trees.trees[0].loopEnd, 1u);
    const JointTrees::Joint& loop = trees.loops[0];
    expectAtRest(world, loop);
    EXPECT_EQ(trees.joints.at(loop.bodyJoint).body, loop.body);
    EXPECT_EQ(trees.joints.at(loop.parentJoint).body, loop.parent);
}

TEST(JointTrees, AChainHeldAtBothEndsClosesThroughTheGround)
{
    const World world = joinedWorld(5, {{0, 1}, {1, 2}, {2, 3}, {3, 4}}, {0, 4});
    const JointTrees trees(world);
    expectTrees(trees);
    ASSERT_EQ(trees.trees.size(), 1u);
    EXPECT_EQ(trees.joints.size(), 3u);
    ASSERT_EQ(trees.loops.size(), 1u);
    EXPECT_EQ(trees.loops[0].parentJoint, NO_INDEX) << "held by a fixed body";
    expectAtRest(world, trees.loops[0]);
}

TEST(JointTrees, TheJointWithMoreParticlesIsNotTheOneThatIsCut)
{
    for (uint32_t ball = 0; ball < 3; ++ball) {
        std::vector<Joining> joints = {{0, 1, JointType::Hinge}, {1, 2, JointType::Hinge}, {2, 0, JointType::Hinge}};
        joints[ball].type = JointType::Ball;
        const JointTrees trees(joinedWorld(3, joints));
        ASSERT_EQ(trees.loops.size(), 1u);
        EXPECT_EQ(trees.loops[0].freedom, JOINT_BALL);
    }
}

TEST(JointTrees, AWorldWithoutJointsHasNone)
{
    const JointTrees trees(joinedWorld(3, {}));
    EXPECT_TRUE(trees.trees.empty());
    EXPECT_TRUE(trees.all().empty());
}

}  // namespace knuckle::test
