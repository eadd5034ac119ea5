#include <cmath>

#include "sim/solver/measure/animated_depths.h"
#include "tests/app/one_object_scene.h"

namespace knuckle::test {

namespace {

std::string box(const std::string& keys, const std::string& more = "")
{
    return R"({"type": "rigid", "shape": "box", "position": [1, 2, 3], "rotation": [0, 90, 0], "motion": {"keys": [)" +
           keys + "]" + more + "}}";
}

Pose placeAt(const World& world, double time)
{
    return bodyPlaces(world, world.animations[0], time)[0];
}

}  // namespace

/// Keys are offsets in the object's own directions: here x is -z of the world.
TEST(SceneMotion, GoesFromKeyToKeyInTheObjectsOwnDirections)
{
    const World world = worldOf(
        box(R"({"time": 0}, {"time": 2, "position": [4, 0, 0]}, {"time": 3, "position": [4, 1, 0]})",
            R"(, "path": "linear", "loop": false)"));
    EXPECT_EQ(world.bodies[0].motion, Motion::Animated);
    // The spline of a 60th of a second rounds corners.
    EXPECT_LT((placeAt(world, 1).translation - Vector3f(1, 2, 1)).norm(), 1e-4f);
    EXPECT_LT((placeAt(world, 2.5).translation - Vector3f(1, 2.5f, -1)).norm(), 1e-4f);
    EXPECT_LT((placeAt(world, 9).translation - Vector3f(1, 3, -1)).norm(), 1e-4f);
}

TEST(SceneMotion, ASmoothPathRestsAtItsEndsAndGoesThroughItsKeys)
{
    const World world = worldOf(
        box(R"({"time": 0}, {"time": 1, "position": [0, 1, 0]}, {"time": 2, "position": [0, 0, 0]})"));
    const auto height = [&](double time) { return placeAt(world, time).translation.y() - 2; };
    EXPECT_NEAR(height(1), 1, 1e-4f);
    EXPECT_NEAR(height(0.5), 0.5, 1e-3f);
    EXPECT_NEAR((height(0.02) - height(0)) / 0.02, 0, 0.1);
    EXPECT_NEAR(height(2.5), height(0.5), 1e-3f) << "it begins anew";
}

TEST(SceneMotion, ADrumTurnsRoundAndRoundAtOneSpeed)
{
    const World world = worldOf(box(R"({"time": 0}, {"time": 2, "rotation": [0, 0, 360]})", R"(, "path": "linear")"));
    for (const double time : {0.3, 1.1, 1.9, 2.3, 7.7}) {
        const Quaternionf a = placeAt(world, time).rotation, b = placeAt(world, time + 0.05).rotation;
        EXPECT_NEAR(a.angularDistance(b), 0.05 * M_PI, 2e-3) << "at " << time;
    }
}

TEST(SceneMotion, IsLetGoAtATime)
{
    std::string moved = box(R"({"time": 0}, {"time": 2, "position": [4, 0, 0]})");
    moved.insert(moved.size() - 1, R"(, "release": {"time": 1.5})");
    EXPECT_EQ(worldOf(moved).bodies[0].releaseTime, 1.5f);
}

TEST(SceneMotion, MistakesAreToldInOneLine)
{
    EXPECT_EQ(complaintOf(box(R"({"time": 1})")), "/objects/0/motion/keys/0/time: must be 0: a motion begins when the "
                                                  "film does");
    EXPECT_EQ(complaintOf(box(R"({"time": 0}, {"time": 0})")),
              "/objects/0/motion/keys/1/time: must be after that of the key before");
    std::string both = box(R"({"time": 0})");
    both.insert(both.size() - 1, R"(, "fixed": true)");
    EXPECT_EQ(complaintOf(both), "/objects/0/motion: is for what is not fixed; take one of them away");
    std::string fast = box(R"({"time": 0})");
    fast.insert(fast.size() - 1, R"(, "spin": [0, 1, 0])");
    EXPECT_EQ(complaintOf(fast), "/objects/0/motion: says how fast it is; take `velocity` and `spin` away");
}

/// All parts of a collider move about its position, in its own directions: stairs of two steps, turned by 90 degrees
/// about y, rise by 1 m and turn once about their z, the world's x.
TEST(SceneMotion, ACollidersPartsMoveTogetherAboutItsPosition)
{
    const World world = worldOf(
        R"({"type": "rigid", "shape": "box"})",
        R"("colliders": [{"type": "plane"}, {"type": "stairs", "steps": 2, "rise": 0.2, "run": 0.3,
        "landing": 0.3, "position": [1, 2, 3], "rotation": [0, 90, 0], "motion": {"path": "linear", "loop": false,
        "keys": [{"time": 0}, {"time": 2, "position": [0, 1, 0], "rotation": [0, 0, 180]}]}}], )");
    ASSERT_EQ(world.colliderMotions.size(), 1u);
    EXPECT_EQ(world.colliderMotions[0].firstCollider, 1u);
    ASSERT_EQ(world.colliderMotions[0].places.size(), 2u);
    const std::vector<Collider> end = collidersAt(world, 5);
    EXPECT_EQ(end[0].position, world.colliders[0].position) << "the plane";
    for (size_t c = 1; c < 3; ++c) {
        const Vector3f before = world.colliders[c].position - Vector3f(1, 2, 3);
        const Vector3f after = end[c].position - Vector3f(1, 3, 3);
        EXPECT_LT((after - Vector3f(before.x(), -before.y(), -before.z())).norm(), 1e-5f) << c;
        EXPECT_NEAR(end[c].orientation.angularDistance(world.colliders[c].orientation), M_PI, 1e-3) << c;
    }
}

/// A collider whose first key is elsewhere is there from the start.
TEST(SceneMotion, ACollidersFirstKeyIsWhereItBegins)
{
    const World world = worldOf(
        R"({"type": "rigid", "shape": "box"})",
        R"("colliders": [{"type": "sphere", "motion": {"keys": [{"time": 0, "position": [0, 2, 0]},
        {"time": 1, "position": [0, 3, 0]}]}}], )");
    EXPECT_LT((world.colliders[0].position - Vector3f(0, 2, 0)).norm(), 1e-6f);
}

TEST(SceneMotion, MistakesOfACollidersMotionAreToldInOneLine)
{
    const auto complaint = [](const std::string& motion, const std::string& more = "") {
        return complaintOf(
            R"({"type": "rigid", "shape": "box"})",
            more + R"("colliders": [{"type": "plane"}, {"type": "sphere", "motion": )" + motion + "}], ");
    };
    EXPECT_EQ(complaint(R"({"keys": [{"time": 1}]})"),
              "/colliders/1/motion/keys/0/time: must be 0: a motion begins when the film does");
    EXPECT_EQ(complaint(R"({"keys": [{"time": 0}, {"time": 0}]})"),
              "/colliders/1/motion/keys/1/time: must be after that of the key before");
    EXPECT_NE(complaint(R"({"keyz": []})").find("/colliders/1/motion/keyz: unknown field"), std::string::npos);
    EXPECT_EQ(complaint(R"({"keys": [{"time": 0}]})", R"("solver": "paper", )"),
              "the paper's solver has no colliders that move; take their `motion` away, or use solver method impulse");
}

/// An animated box stands at the origin; a collider overlaps it by 1 m.
TEST(SceneMotion, HowFarAMovingColliderComesOverItIsTold)
{
    const World world = worldOf(box(R"({"time": 0})"),
                                R"("colliders": [{"type": "box", "size": [1, 1, 1], "position": [3, 2, 3], "motion": {
        "path": "linear", "loop": false, "keys": [{"time": 0}, {"time": 1, "position": [-2, 0, 0]}]}}], )");
    const std::vector<AnimatedDepth> depths = animatedDepths(world, 1.5f);
    ASSERT_EQ(depths.size(), 1u);
    EXPECT_EQ(depths[0].collider, 0u);
    // Then its middle is the box's: a lattice knows the way out of the box within a diameter.
    EXPECT_NEAR(depths[0].depth, 0.5f, world.diameter());
    EXPECT_NEAR(depths[0].time, 1, 0.1f);
}

/// A box of 0.3 m moves by 1 m into a wall that begins 0.5 m ahead, and into another one that stands still.
TEST(SceneMotion, HowFarItGoesThroughWhatItCannotPushIsTold)
{
    const auto mover = [](const std::string& position, const std::string& way) {
        return R"({"type": "rigid", "shape": "box", "size": [0.3, 0.3, 0.3], "position": )" + position +
               R"(, "motion": {"path": "linear", "loop": false, "keys": [{"time": 0}, {"time": 1, "position": )" + way +
               "}]}}";
    };
    const World world = worldOf(mover("[0, 0, 0]", "[1, 0, 0]") + ", " + mover("[0, 0.2, 0]", "[0, 0, 0]"),
                                R"("colliders": [{"type": "box", "size": [2, 4, 4], "position": [1.5, 0, 0]}], )");
    const std::vector<AnimatedDepth> depths = animatedDepths(world, 3);
    ASSERT_EQ(depths.size(), 2u);
    EXPECT_EQ(depths[0].collider, 0u);
    EXPECT_NEAR(depths[0].depth, 1 + 0.15f - 0.5f, 1e-3f);
    EXPECT_NEAR(depths[0].time, 1, 0.06f);
    EXPECT_EQ(depths[1].other, 1u);
    // The two overlap by 0.1 m; lattices know this within a diameter.
    EXPECT_NEAR(depths[1].depth, 0.1f, world.diameter());
    EXPECT_TRUE(animatedDepths(world, 0.3f).size() == 1) << "not in the wall yet";
}

}  // namespace knuckle::test
