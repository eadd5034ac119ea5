#include <algorithm>
#include <memory>
#include <string>

#include "shared/joint_records.h"
#include "tests/solver/joint/joined_world.h"
#include "tests/solver/joint/joint_fixture.h"

namespace knuckle::test {

namespace {

using Vector6d = JointFixture::Vector6d;

/// Single precision, times the ratio of inertias and arms in a tree.
constexpr double ROUNDING = 1e-5;

struct JointCase {
    const char* name;
    World (*world)();
    bool loops;
    double tolerance;  ///< Of motions and forces, relative to the largest.
};

World chainHeldTwice()
{
    return joinedWorld(6, {{0, 1}, {1, 2, JointType::Hinge}, {2, 3}, {3, 4}, {4, 5}}, {0, 5}, 5000.0f);
}

World heavyAtTheEnd()
{
    // 100 : 1 between neighbours, at the end of a chain of twenty.
    std::vector<Joining> joints;
    for (uint32_t k = 0; k < 19; ++k) joints.push_back({k, k + 1, JointType::Ball});
    return joinedWorld(20, joints, {0}, 100'000.0f);
}

World branched()
{
    return branchedWorld();
}

World mixed()
{
    return mixedWorld();
}

class JointSolve : public testing::TestWithParam<JointCase> {
protected:
    JointSolve() : fixture(GetParam().world()), wanted(fixture.solution())
    {
        fixture.solve(GetParam().loops);
        rows = fixture.stages.bodies.rowImpulses.download();
        angularRows = fixture.stages.bodies.rowAngularImpulses.download();
        jointInfo = fixture.stages.joints.jointInfo.download();
    }

    /// What the channel's rows of a joint gained: linear and angular parts.
    Vector6d gained(uint32_t row) const
    {
        Vector6d g;
        g << (vec3(rows[row]) - vec3(fixture.rows[row])).cast<double>(), Vector3d::Zero();
        if (!angularRows.empty())
            g.tail<3>() = (vec3(angularRows[row]) - vec3(fixture.angularRows[row])).cast<double>();
        return g;
    }

    JointFixture fixture;
    JointFixture::Solution wanted;
    std::vector<gpu::vec4> rows, angularRows;
    std::vector<gpu::Joint> jointInfo;
};

TEST_P(JointSolve, BodiesMoveAsADenseSolveOfAllTheirJointsSays)
{
    const auto moves = fixture.stages.bodies.moverMoves.download();
    const auto turns = fixture.stages.bodies.moverRotationDeltas.download();
    double largest = 0.0;
    for (const JointTrees::Joint& joint : fixture.trees().joints)
        largest = std::max(largest, wanted.motions[joint.body].norm());
    for (const JointTrees::Joint& joint : fixture.trees().joints) {
        const uint32_t b = joint.body;
        Vector6d motion;
        motion.head<3>() = (vec3(moves[b]) - vec3(fixture.moves[b])).cast<double>();
        const Eigen::Quaterniond turn = quaternion(turns[b]).cast<double>() *
                                        quaternion(fixture.turns[b]).cast<double>().conjugate();
        const Eigen::AngleAxisd angle(turn);
        motion.tail<3>() = angle.angle() * angle.axis();
        // Differences of moves and of quaternions about 1 have rounding themselves.
        EXPECT_LT((motion - wanted.motions[b]).norm(), GetParam().tolerance * largest + 4 * EPSILON) << "body " << b;
    }
    EXPECT_GT(largest, 1e-3);
}

TEST_P(JointSolve, RowsGainTheForcesThatHoldTheJoints)
{
    const auto joints = fixture.trees().all();
    Vector6d largest = Vector6d::Zero();
    for (const Vector6d& held : wanted.held) largest = largest.cwiseMax(held.cwiseAbs());
    for (size_t j = 0; j < joints.size(); ++j) {
        if (joints[j].freedom == JOINT_NONE) continue;
        const Vector6d off = gained(jointInfo[j].row) - wanted.held[j];
        EXPECT_LT(off.head<3>().norm(), GetParam().tolerance * largest.head<3>().norm()) << "joint " << j;
        EXPECT_LT(off.tail<3>().norm(), GetParam().tolerance * largest.norm()) << "joint " << j;
    }
}

TEST_P(JointSolve, WhatABodyGainsItsParentLoses)
{
    const auto joints = fixture.trees().all();
    for (size_t j = 0; j < joints.size(); ++j) {
        const gpu::Joint own = jointInfo[j];
        if (joints[j].freedom == JOINT_NONE || own.parentRow == NO_INDEX) continue;
        // Each was added to the old contents.
        const double size = vec3(rows[own.row]).norm() + vec3(rows[own.parentRow]).norm() + 0.2;
        EXPECT_LT((gained(own.row) + gained(own.parentRow)).norm(), 4 * EPSILON * size) << "joint " << j;
    }
}

TEST_P(JointSolve, EachBodyAnswersToAForceWithAllThatItsJointsMoveAlong)
{
    const auto found = fixture.stages.joints.bodyResponses.download();
    // Loops do not count: responses belong to the tree.
    if (GetParam().loops) return;
    for (const JointTrees::Joint& joint : fixture.trees().joints) {
        const JointFixture::Matrix6d w = fixture.response(joint.body);
        JointFixture::Matrix6d answer = JointFixture::Matrix6d::Zero();
        for (uint32_t c = 0; c < 3; ++c) {
            answer.col(c) << vec3(found[BODY_RESPONSE_TEXELS * joint.body + c]).cast<double>(),
                vec3(found[BODY_RESPONSE_TEXELS * joint.body + 3 + c]).cast<double>();
            answer.col(3 + c).tail<3>() = vec3(found[BODY_RESPONSE_TEXELS * joint.body + 6 + c]).cast<double>();
        }
        answer.topRightCorner<3, 3>() = answer.bottomLeftCorner<3, 3>().transpose();
        EXPECT_LT((answer - w).norm(), 10 * GetParam().tolerance * w.norm()) << "body " << joint.body;
    }
}

TEST_P(JointSolve, OthersStay)
{
    const auto moves = fixture.stages.bodies.moverMoves.download();
    for (uint32_t m = 0; m < fixture.moverCount(); ++m) {
        if (m < fixture.world.bodies.size() && !fixture.isFixed(m) &&
            std::ranges::find(fixture.trees().joints, m, &JointTrees::Joint::body) != fixture.trees().joints.end())
            continue;
        EXPECT_EQ(vec3(moves[m]), vec3(fixture.moves[m])) << "mover " << m;
    }
}

// A loop is kept regular by 1e-4 of its own response.
INSTANTIATE_TEST_SUITE_P(Worlds, JointSolve,
                         testing::Values(JointCase{"branched", branched, false, ROUNDING},
                                         JointCase{"mixed", mixed, false, ROUNDING},
                                         JointCase{"heavyAtTheEnd", heavyAtTheEnd, false, 100 * ROUNDING},
                                         JointCase{"ring", ringWorld, true, 1e-3},
                                         JointCase{"chainHeldTwice", chainHeldTwice, true, 1e-3}),
                         [](const auto& tested) { return tested.param.name; });

/// The world with some bodies that do not respond, prepared and solved.
class JointSolveHeld : public testing::Test {
protected:
    /// @param held by body.
    void solveWith(const std::vector<bool>& held, uint32_t state, bool loops = false)
    {
        auto states = fixture->stages.bodies.moverStates.download();
        for (uint32_t b = 0; b < held.size(); ++b)
            if (held[b]) states[b] = state;
        fill(fixture->stages.bodies.moverStates, states);
        fixture->solve(loops);
    }
    bool stayed(uint32_t body) const
    {
        return vec3(fixture->stages.bodies.moverMoves.download()[body]) == vec3(fixture->moves[body]);
    }
    std::unique_ptr<JointFixture> fixture;
};

TEST_F(JointSolveHeld, ATreeThatSleepsStays)
{
    fixture = std::make_unique<JointFixture>(branchedWorld());
    // The hinge that a fixed body holds sleeps, the others do not.
    const uint32_t sleeper = fixture->world.bodies[7].assembly;
    std::vector<bool> asleep;
    for (const Body& body : fixture->world.bodies) asleep.push_back(body.assembly == sleeper);
    solveWith(asleep, MOVER_ASLEEP);
    for (const JointTrees::Joint& joint : fixture->trees().joints)
        EXPECT_EQ(stayed(joint.body), asleep[joint.body]) << "body " << joint.body;
}

TEST_F(JointSolveHeld, ABodyThatDoesNotRespondHoldsWhatHangsOnIt)
{
    // The same chain, held once by a body that is fixed for ever, once by one that is fixed for now.
    const std::vector<Joining> chain = {{0, 1}, {1, 2, JointType::Hinge}, {2, 3, JointType::Stiff}, {3, 4}};
    // Joints remember nothing, since the two worlds have different rows.
    const auto forget = [](JointFixture& f) {
        fill(f.stages.bodies.rowAngularImpulses, std::vector<gpu::vec4>(f.angularRows.size()));
    };
    JointFixture forEver(joinedWorld(5, chain, {0}, 3000.0f));
    forget(forEver);
    forEver.solve(false);
    World world = joinedWorld(5, chain, {0}, 3000.0f);
    world.bodies[0].releaseTime = 1.0f;
    fixture = std::make_unique<JointFixture>(world);
    ASSERT_EQ(fixture->trees().joints.size(), 5u) << "it belongs to the tree";
    forget(*fixture);
    fixture->solve(false);
    EXPECT_TRUE(stayed(0));
    const auto wanted = forEver.stages.bodies.moverMoves.download(),
               found = fixture->stages.bodies.moverMoves.download();
    for (uint32_t b = 1; b < 5; ++b) {
        // The same sums in the same order.
        EXPECT_EQ(vec3(found[b]), vec3(wanted[b])) << "body " << b;
        EXPECT_FALSE(stayed(b));
    }
}

}  // namespace

}  // namespace knuckle::test
