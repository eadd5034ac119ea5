#include "sim/rig/limbs/limb_lattice.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace knuckle {
namespace {

using Eigen::Vector3f;

// A bone 1.06 m long in a general direction; eleven diameters of 0.1 m are 1.1 m.
LimbFrame tiltedFrame()
{
    LimbFrame frame;
    frame.head = {0.3f, 1.2f, -0.4f};
    frame.end = frame.head + 1.06f * Vector3f(2, -3, 1).normalized();
    frame.across = Vector3f(1, 1, 1).normalized();  // across (2, -3, 1)
    frame.radius = 0.3f;
    return frame;
}

bool isInCylinder(const LimbFrame& frame, const Vector3f& place, float radius)
{
    const Vector3f from = place - frame.head;
    const float way = from.dot(frame.along());
    return way > -0.001f && way < frame.length() + 0.001f && (from - way * frame.along()).norm() < radius;
}

size_t placesIn(const SlicePattern& pattern, float radius)
{
    const LimbFrame frame = tiltedFrame();
    return limbPlaces(frame, pattern, 0.1f, [&](const Vector3f& p) { return isInCylinder(frame, p, radius); }).size();
}

TEST(LimbLattice, slicesAreRingsSquaresAndTriangles)
{
    // 11 spacings from head to end are 12 slices. Neighbours are 0.109 m apart in triangles, 0.102 m in squares.
    EXPECT_EQ(placesIn({true, {0, 0}}, 0.13f), 12u * 7u);
    EXPECT_EQ(placesIn({true, {0.5f, 0.2887f}}, 0.08f), 12u * 3u);
    EXPECT_EQ(placesIn({false, {0, 0}}, 0.15f), 12u * 9u);
    EXPECT_EQ(placesIn({false, {0.5f, 0.5f}}, 0.08f), 12u * 4u);
    EXPECT_EQ(placesIn({false, {0, 0.5f}}, 0.13f), 12u * 6u);
}

TEST(LimbLattice, firstAndLastSliceAreAtTheJoints)
{
    const LimbFrame frame = tiltedFrame();
    const auto places = limbPlaces(frame, {true, {0, 0}}, 0.1f,
                                   [&](const Vector3f& p) { return isInCylinder(frame, p, 0.01f); });
    ASSERT_EQ(places.size(), 12u);
    EXPECT_LT((places.front() - frame.head).norm(), 1e-6f);
    EXPECT_LT((places.back() - frame.end).norm(), 1e-5f);
}

TEST(LimbLattice, eachPlaceStandsForACubeOfADiameter)
{
    // 12 slices, each 0.9636 d thick, of cylinders of 6 to 9 diameters across. The number of places in a circle jumps
    // by a tenth as it grows; for ten circles that is 3 % on average.
    LimbFrame frame = tiltedFrame();
    frame.radius = 0.5f;
    for (const SlicePattern& pattern : SLICE_PATTERNS) {
        double ratio = 0.0;
        for (int i = 0; i < 10; ++i) {
            const float radius = 0.3f + 0.015f * static_cast<float>(i);
            const auto places = limbPlaces(frame, pattern, 0.1f,
                                           [&](const Vector3f& p) { return isInCylinder(frame, p, radius); });
            const double volume = 12 * 0.09636 * std::numbers::pi * radius * radius;
            ratio += 0.1 * static_cast<double>(places.size()) * 1e-3 / volume;
        }
        EXPECT_NEAR(ratio, 1.0, 0.06);
    }
}

TEST(LimbLattice, errorIsHowFarTheSurfaceIsFromHalfADiameter)
{
    const std::vector<Vector3f> particles{{0, 0, 0}, {1, 0, 0}};
    // 0.5, 0.7 and 0.1 diameters of 1 from the nearest one.
    EXPECT_NEAR(surfaceError(particles, {{0, 0.5f, 0}}, 1.0f), 0.0f, 1e-6f);
    EXPECT_NEAR(surfaceError(particles, {{0, 0.7f, 0}, {1, 0.1f, 0}}, 1.0f), std::sqrt((0.04f + 0.16f) / 2), 1e-6f);
    EXPECT_EQ(surfaceError(particles, {}, 1.0f), 0.0f);
}

}  // namespace
}  // namespace knuckle
