#include <algorithm>
#include <cmath>

#include "shared/joint_records.h"
#include "tests/solver/joint/joined_world.h"
#include "tests/solver/joint/joint_fixture.h"

namespace knuckle::test {

namespace {

constexpr float LOWEST = -0.3f, HIGHEST = 0.2f, SWING = 0.4f;
constexpr double STIFFNESS = 40.0;  ///< Of every second hinge [N m/rad].

/// Hinges and balls with limits, each of a body on a fixed one; more than the threads of a work group.
World limitedPairs()
{
    std::vector<Joining> joints;
    std::vector<uint32_t> fixed;
    constexpr uint32_t PAIRS = 45;
    for (uint32_t p = 0; p < PAIRS; ++p) {
        fixed.push_back(2 * p);
        joints.push_back({2 * p, 2 * p + 1, p % 3 == 2 ? JointType::Ball : JointType::Hinge});
    }
    World world = joinedWorld(2 * PAIRS, joints, fixed);
    for (size_t j = 0; j < world.joints.size(); ++j) {
        TurnLimits& limits = world.joints[j].limits;
        limits.twist = {LOWEST, HIGHEST};
        if (world.joints[j].type == JointType::Ball) limits.swing = SWING;
        else if (j % 2 == 1) limits.stiffness = static_cast<float>(STIFFNESS);
    }
    return world;
}

/// How far a joint exceeds its limits, and the axes about which its body turns further beyond them.
struct Excess {
    double swing = -4.0, turn = -4.0;
    Vector3d swingAxis = Vector3d::Zero(), turnAxis = Vector3d::Zero();
};

class JointLimitStates : public testing::Test {
protected:
    JointLimitStates() : fixture(limitedPairs()), joints(fixture.trees().joints)
    {
        // Each body turned about its joint, from the rest pose, at the start of the substep; nothing has moved since.
        Random random(61);
        auto rotations = fixture.rotations;
        for (const JointTrees::Joint& joint : joints) {
            const Quaternionf parent = quaternion(rotations[joint.parent]) * joint.parentSide.frame;
            const Vector3f x = parent * Vector3f::UnitX();
            Quaternionf turn(Eigen::AngleAxisf(random.between(-0.8f, 0.8f), x));
            if (joint.freedom == JOINT_BALL) {
                const Vector3f across = x.cross(random.direction()).normalized();
                turn = Quaternionf(Eigen::AngleAxisf(random.between(0, 0.8f), across)) * turn;
            }
            rotations[joint.body] = packed(turn * parent * joint.side.frame.conjugate());
        }
        fixture.rotations = rotations;
        fixture.setMoves(0.0f, 0.0f, 1.0f);
        fill(fixture.stages.bodies.moverRotations, rotations);
        fixture.setAssemblies(0, 1);
    }
    /// Swing and twist of the body's frame against its parent's, in double precision.
    Excess excessOf(const JointTrees::Joint& joint) const
    {
        const Eigen::Quaterniond from = fixture.rotation(joint.parent) * joint.parentSide.frame.cast<double>();
        const Eigen::Quaterniond to = fixture.rotation(joint.body) * joint.side.frame.cast<double>();
        const Vector3d middle = from * Vector3d::UnitX(), axis = to * Vector3d::UnitX();
        Excess excess;
        if (joint.freedom == JOINT_BALL) {
            excess.swing = std::atan2(middle.cross(axis).norm(), middle.dot(axis)) - double(SWING);
            excess.swingAxis = middle.cross(axis).normalized();
        }
        const Eigen::Quaterniond twist = Eigen::Quaterniond::FromTwoVectors(axis, middle) * to * from.conjugate();
        const double angle = 2 * std::atan2(twist.vec().dot(middle), twist.w());
        const double wrapped = std::remainder(angle, 2 * M_PI), centre = 0.5 * double(LOWEST + HIGHEST);
        const bool above = wrapped > centre;
        excess.turn = above ? wrapped - double(HIGHEST) : double(LOWEST) - wrapped;
        excess.turnAxis = (above ? 1.0 : -1.0) / (1.0 + middle.dot(axis)) * (middle + axis);
        return excess;
    }
    /// Half of the excess over a limit is corrected, at most at 1 rad/s.
    double kept(double excess) const
    {
        const double h = fixture.stages.parameters.substepTime;
        return excess <= 0.0 ? 0.0 : excess * (1.0 - std::min(0.5, 1.0 * h / excess));
    }
    /// The body's inertia against turns about its joint.
    Matrix3d inertiaAt(const JointTrees::Joint& joint) const
    {
        const Vector3d arm = fixture.rotation(joint.body) * joint.side.arm.cast<double>();
        return fixture.hessians[joint.body] +
               fixture.masses[joint.body] * (arm.squaredNorm() * Matrix3d::Identity() - arm * arm.transpose());
    }
    bool isSoft(const JointTrees::Joint& joint) const
    {
        return std::isfinite(fixture.world.joints[joint.joint].limits.stiffness);
    }
    void factor(const Defines& more = {})
    {
        Defines variant{{"LIMITS", "1"}};
        variant.insert(variant.end(), more.begin(), more.end());
        fixture.dispatch(fixture.load("joint/joint_factor", variant),
                         (fixture.stages.parameters.jointTreeCount + TREE_GROUP_SIZE - 1) / TREE_GROUP_SIZE);
        gpu().checkErrors();
        stops = fixture.stages.joints.jointLimitStates.download();
    }
    /// Turns all hinges beyond their upper limit by this much, at the start of the substep. The others stay.
    void turnHingesTo(float excess)
    {
        for (const JointTrees::Joint& joint : joints) {
            if (joint.freedom != JOINT_HINGE) continue;
            const Quaternionf parent = quaternion(fixture.rotations[joint.parent]) * joint.parentSide.frame;
            const Quaternionf turn(Eigen::AngleAxisf(HIGHEST + excess, Vector3f::UnitX()));
            fixture.rotations[joint.body] = packed(parent * turn * joint.side.frame.conjugate());
        }
        fill(fixture.stages.bodies.moverRotations, fixture.rotations);
    }
    static float memory(size_t joint) { return joint % 4 == 0 ? 1.0f : 0.0f; }
    /// As if an earlier substep had left all stops holding equally hard.
    void holdAll()
    {
        stops.assign(JOINT_LIMIT_TEXELS * joints.size(), {0, 0, 0, 0});
        for (size_t j = 0; j < joints.size(); ++j) {
            stops[JOINT_LIMIT_TEXELS * j] = stops[JOINT_LIMIT_TEXELS * j + 1] = {1, 0, 0, 7};
            stops[JOINT_LIMIT_TEXELS * j + 2] = {3, 3, 0, 0};
            stops[JOINT_LIMIT_TEXELS * j + 3] = {0, 0, 0, memory(j)};
        }
        fill(fixture.stages.joints.jointLimitStates, stops);
    }
    /// @returns the numbers of rigid and of soft hinges' stops that hold.
    std::pair<uint32_t, uint32_t> countHolding() const
    {
        std::pair<uint32_t, uint32_t> count{0, 0};
        for (size_t j = 0; j < joints.size(); ++j)
            if (joints[j].freedom == JOINT_HINGE && stop(j, 1).w > 0.0f)
                ++(isSoft(joints[j]) ? count.second : count.first);
        return count;
    }
    gpu::vec4 stop(size_t joint, uint32_t part) const { return stops[JOINT_LIMIT_TEXELS * joint + part]; }

    JointFixture fixture;
    std::vector<JointTrees::Joint> joints;
    std::vector<gpu::vec4> stops;
};

TEST_F(JointLimitStates, HoldWhatExceedsALimitAndNothingElse)
{
    factor();
    uint32_t holding = 0, free = 0;
    for (size_t j = 0; j < joints.size(); ++j) {
        const Excess excess = excessOf(joints[j]);
        const double h = fixture.stages.parameters.substepTime;
        for (uint32_t part : {0u, 1u}) {
            SCOPED_TRACE("joint " + std::to_string(j) + ", stop " + std::to_string(part));
            const double over = part == 0 ? excess.swing : excess.turn;
            const Vector3d axis = part == 0 ? excess.swingAxis : excess.turnAxis;
            const gpu::vec4 found = stop(j, part);
            if (std::abs(over) < 1e-3) continue;  // rounding decides
            (over > 0 ? holding : free) += 1;
            if (over < 0) {
                EXPECT_EQ(found.w, 0.0f);
                continue;
            }
            // Angles of a few tenths, rounded some twenty times.
            EXPECT_LT((vec3(found).cast<double>() - axis).norm(), 1e-5);
            const double hardness = isSoft(joints[j]) ? STIFFNESS * h * h
                                                      : 100.0 * axis.dot(inertiaAt(joints[j]) * axis);
            EXPECT_NEAR(found.w, hardness, 1e-4 * hardness);
            const gpu::vec4 held = stop(j, 2);
            EXPECT_NEAR(part == 0 ? held.z : held.w, isSoft(joints[j]) ? 0.0 : kept(over), 1e-5);
        }
    }
    EXPECT_GT(holding, 20u);
    EXPECT_GT(free, 20u);
}

TEST_F(JointLimitStates, WhereTheSameOnesHoldNothingIsDoneAgain)
{
    factor();
    const auto factors = fixture.stages.joints.jointFactors.download(), before = stops;
    fixture.stages.joints.jointFactors.clear();
    factor({{"AGAIN", "1"}});
    for (const gpu::vec4& texel : fixture.stages.joints.jointFactors.download())
        EXPECT_EQ(vec3(texel), Vector3f(0, 0, 0)) << "no set of stops has changed";
    for (size_t k = 0; k < before.size(); ++k) EXPECT_EQ(stops[k].w, before[k].w);
}

TEST_F(JointLimitStates, ARigidOneThatHeldGoesOnFromWhereItIs)
{
    for (float excess : {-0.004f, -0.006f}) {
        SCOPED_TRACE(excess);
        turnHingesTo(excess);
        holdAll();
        factor();
        const bool goesOn = excess > -0.005f;  // how far a stop may be from its limit and still hold
        EXPECT_EQ(countHolding(), std::make_pair(goesOn ? 15u : 0u, 0u));
        for (size_t j = 0; j < joints.size(); ++j) {
            if (joints[j].freedom != JOINT_HINGE) continue;
            EXPECT_EQ(stop(j, 2).y, stop(j, 1).w > 0.0f ? 3 * memory(j) : 0.0f);
            // Angles of a few tenths, rounded some twenty times.
            EXPECT_NEAR(stop(j, 2).w, stop(j, 1).w > 0.0f ? 0.9f * excess : 0.0f, 1e-5);
        }
    }
}

TEST_F(JointLimitStates, WhatPullsLetsGoButARigidOneNotInTheLastIteration)
{
    for (bool last : {false, true}) {
        SCOPED_TRACE(last);
        turnHingesTo(0.01f);
        fixture.setMoves(0.0f, 0.0f, 1.0f);
        factor();
        EXPECT_EQ(countHolding(), std::make_pair(15u, 15u));
        // Turns bodies back, to within their limits.
        auto turns = fixture.turns;
        for (const JointTrees::Joint& joint : joints) {
            const Vector3f x = quaternion(fixture.rotations[joint.parent]) * joint.parentSide.frame * Vector3f::UnitX();
            turns[joint.body] = packed(Quaternionf(Eigen::AngleAxisf(-0.02f, x)));
        }
        fill(fixture.stages.bodies.moverRotationDeltas, turns);
        factor(last ? Defines{{"AGAIN", "1"}, {"LAST", "1"}} : Defines{{"AGAIN", "1"}});
        EXPECT_EQ(countHolding(), std::make_pair(last ? 15u : 0u, 0u));
    }
}

TEST_F(JointLimitStates, WhatTurnedOntoAStopInTheSubstepIsOfFirstOrder)
{
    fixture.setAssemblies(0, 2);
    // All bodies come from the rest pose in this substep, to their places in the others.
    auto starts = fixture.rotations, turns = fixture.turns;
    for (const JointTrees::Joint& joint : joints) {
        const Quaternionf rest = quaternion(fixture.rotations[joint.parent]) * joint.parentSide.frame *
                                 joint.side.frame.conjugate();
        turns[joint.body] = packed(quaternion(fixture.rotations[joint.body]) * rest.conjugate());
        starts[joint.body] = packed(rest);
    }
    fill(fixture.stages.bodies.moverRotations, starts);
    fill(fixture.stages.bodies.moverRotationDeltas, turns);
    factor();
    const auto orders = fixture.stages.particles.assemblyState.download();
    uint32_t count = 0;
    for (const JointTrees::Joint& joint : joints) {
        const Excess excess = excessOf(joint);
        if (std::abs(excess.swing) < 1e-3 || std::abs(excess.turn) < 1e-3) continue;
        const bool isStopped = excess.swing > 0 || excess.turn > 0;
        count += isStopped;
        EXPECT_EQ(orders[fixture.world.bodies[joint.body].assembly].y, isStopped ? 1u : 2u) << "body " << joint.body;
    }
    EXPECT_GT(count, 15u);
}

}  // namespace

}  // namespace knuckle::test
