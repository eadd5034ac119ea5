#include "sim/world/space/frames.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/directions.h"

namespace knuckle::test {
namespace {

void expectTurns(const Vector3f& from, const Vector3f& to)
{
    const Quaternionf turn = turnBetween(from, to);
    ASSERT_NEAR(turn.norm(), 1.0f, 1e-5f) << from.transpose() << " to " << to.transpose();
    ASSERT_LT((turn * from - to).norm(), 1e-5f) << from.transpose() << " to " << to.transpose();
}

TEST(Frames, ATurnBringsEachDirectionToEachAxis)
{
    for (const Vector3f& way : directions()) {
        for (int axis = 0; axis < 3; ++axis) {
            expectTurns(Vector3f::Unit(axis), way);
            expectTurns(way, -Vector3f::Unit(axis));
        }
        expectTurns(way, -way);
        expectTurns(way, way);
    }
}

TEST(Frames, ATurnIsTheShortest)
{
    for (float angle = 3.0f; angle < 3.1415f; angle += 0.5f * (3.14159f - angle)) {
        const Vector3f to(std::cos(angle), std::sin(angle), 0);
        const Quaternionf turn = turnBetween(Vector3f::UnitX(), to);
        EXPECT_LT(turn.vec().cross(Vector3f::UnitZ()).norm(), 1e-6f) << angle;
    }
}

TEST(Frames, LengthsSayNothingAndZeroIsNoTurn)
{
    const Quaternionf turn = turnBetween({1e-30f, 0, 0}, {-1e30f, 0, 0});
    EXPECT_NEAR(turn.norm(), 1.0f, 1e-6f);
    EXPECT_LT((turn * Vector3f::UnitX() + Vector3f::UnitX()).norm(), 1e-6f);
    EXPECT_EQ(turnBetween(Vector3f::Zero(), Vector3f::UnitX()).w(), 1.0f);
    EXPECT_EQ(turnBetween(Vector3f::UnitX(), Vector3f::Zero()).w(), 1.0f);
}

TEST(Frames, RightIsLevelAndAcross)
{
    for (const Vector3f& back : directions()) {
        const Vector3f right = levelRight(back);
        EXPECT_NEAR(right.norm(), 1.0f, 1e-5f) << back.transpose();
        EXPECT_NEAR(right.dot(back), 0.0f, 1e-5f) << back.transpose();
        const bool steep = std::abs(back.y()) > 0.99f;
        EXPECT_TRUE(steep || right.y() == 0.0f) << back.transpose();
    }
}

}  // namespace
}  // namespace knuckle::test
