#include "tests/world/world_fixture.h"

namespace knuckle::test {

namespace {

// An anchor and a general frame: axis u, direction from A to B w, and the third one v = w x u.
const Vector3f ANCHOR(0.3f, -0.2f, 0.7f);
const Quaternionf TURN(Eigen::AngleAxisf(0.8f, Vector3f(1, 2, 3).normalized()));
const Vector3f U = TURN * Vector3f::UnitZ();
const Vector3f W = TURN * Vector3f::UnitX();
const Vector3f V = W.cross(U);

JointPlaces placesOf(JointType type, int limitSide = 0)
{
    JointSpec spec;
    spec.type = type;
    spec.anchor = ANCHOR;
    spec.axis = 3.0f * U;              // both not of unit length
    spec.along = 2.0f * W + 0.5f * U;  // and not perpendicular
    spec.limitSide = limitSide;
    return jointPlaces(spec, DIAMETER);
}

/// The same points in any order. A few roundings of numbers below one: 1e-6.
void expectPoints(const std::vector<Vector3f>& actual, const std::vector<Vector3f>& expected)
{
    ASSERT_EQ(actual.size(), expected.size());
    for (const Vector3f& wanted : expected) {
        float nearest = 1e9f;
        for (const Vector3f& p : actual) nearest = std::min(nearest, (p - wanted).norm());
        EXPECT_LT(nearest, 1e-6f) << "nothing at " << wanted.transpose();
    }
}

}  // namespace

TEST(JointPlaces, ABallHasOneSharedParticleAtItsAnchor)
{
    const JointPlaces places = placesOf(JointType::Ball);
    expectPoints(places.shared, {ANCHOR});
    EXPECT_TRUE(places.limits.empty() && places.middle.empty());
}

TEST(JointPlaces, AHingeHasThreeSharedParticlesOnItsAxis)
{
    const JointPlaces places = placesOf(JointType::Hinge);
    expectPoints(places.shared, {ANCHOR - DIAMETER * U, ANCHOR, ANCHOR + DIAMETER * U});
    EXPECT_TRUE(places.limits.empty() && places.middle.empty());
}

TEST(JointPlaces, AHingesLimitsStandBesideItsAxisOnTheSideAskedFor)
{
    for (int side : {1, -1}) {
        const Vector3f beside = ANCHOR + static_cast<float>(side) * DIAMETER * V;
        expectPoints(placesOf(JointType::Hinge, side).limits, {beside - DIAMETER * U, beside + DIAMETER * U});
    }
}

TEST(JointPlaces, AStiffJointHasTheFourCornersOfASquareAcrossIt)
{
    const Vector3f u = DIAMETER * U, v = DIAMETER * V;
    const JointPlaces places = placesOf(JointType::Stiff);
    expectPoints(places.shared, {ANCHOR - u - v, ANCHOR - u + v, ANCHOR + u - v, ANCHOR + u + v});
    for (const Vector3f& p : places.shared) EXPECT_NEAR((p - ANCHOR).dot(W), 0.0f, 1e-6f);
}

TEST(JointPlaces, AUniversalJointIsACrossOfTwoHingesAndAMiddle)
{
    const JointPlaces places = placesOf(JointType::Universal);
    expectPoints(places.sharedWithParent, {ANCHOR - DIAMETER * U, ANCHOR + DIAMETER * U});
    expectPoints(places.sharedWithChild, {ANCHOR - DIAMETER * V, ANCHOR + DIAMETER * V});
    expectPoints(places.middle, {ANCHOR});
    EXPECT_TRUE(places.shared.empty() && places.limits.empty());
}

TEST(JointPlaces, AxesThatAreZeroOrParallelAreRefused)
{
    const std::string wanted =
        "joint \"elbow\": axis and direction must be two vectors that are neither zero nor parallel";
    JointSpec spec;
    spec.name = "elbow";
    for (const Vector3f& axis : {Vector3f(0, 0, 0), Vector3f(2, 0, 0), Vector3f(NAN, 0, 1)}) {
        spec.axis = axis;  // `along` is x
        EXPECT_EQ(misuseOf([&] { jointPlaces(spec, DIAMETER); }), wanted) << axis.transpose();
    }
    spec.axis = Vector3f::UnitZ();
    spec.along = Vector3f::Zero();
    EXPECT_EQ(misuseOf([&] { jointPlaces(spec, DIAMETER); }), wanted);
}

TEST(JointPlaces, EveryTypeHasItsName)
{
    EXPECT_STREQ(jointTypeName(JointType::Ball), "ball");
    EXPECT_STREQ(jointTypeName(JointType::Hinge), "hinge");
    EXPECT_STREQ(jointTypeName(JointType::Stiff), "stiff");
    EXPECT_STREQ(jointTypeName(JointType::Universal), "universal");
}

}  // namespace knuckle::test
