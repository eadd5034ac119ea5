#include <cmath>

#include "sim/solver/strand/strand_order.h"
#include "tests/render/surfaces/matter_fixture.h"

namespace knuckle::test {
namespace {

constexpr float RADIUS = 0.08f;
constexpr uint32_t NODES = 9;

/// A rope along x, or around a circle in the plane of the picture.
StillWorld rope(float circle = 0.0f)
{
    StillWorld still = redMatter(RADIUS);
    std::vector<uint32_t> nodes;
    for (uint32_t k = 0; k < NODES; ++k) {
        const float along = 2.0f * RADIUS * (float(k) - 0.5f * (NODES - 1));
        const float angle = circle > 0.0f ? along / circle : 0.0f;
        nodes.push_back(addLoose(still.world, circle > 0.0f
                                                  ? Vector3f(circle * std::sin(angle), circle * std::cos(angle), 0)
                                                  : Vector3f(along, 0, 0)));
    }
    addStrand(still.world, nodes, 2.0f * RADIUS);
    still.world.drawn.ropes = {0};
    return still;
}

/// A tube's image is that of the tangents from the eye: wider than its radius at its distance.
float widthOf(float distance)
{
    return 2.0f * RADIUS / std::sqrt(1.0f - RADIUS * RADIUS / (distance * distance));
}

TEST(RopeTube, HasTheRadiusOfItsParticles)
{
    // 3 % of the radius for its sixteen sides, and a pixel for its filtered edges.
    const float wanted = pixelsOf(widthOf(0.6f), 0.6f);
    const Image image = drawn(rope().world, redView({0, 0, 0.6f}));
    for (const uint32_t x : {40u, 77u, 100u, 151u})
        EXPECT_NEAR(float(redIn(image, x, false)), wanted, 0.03f * wanted + 1.0f) << x;
}

TEST(RopeTube, EndsInCaps)
{
    const Image image = drawn(rope().world, redView({0, 0, 3}));
    EXPECT_NEAR(float(redIn(image, PICTURE / 2, true)), pixelsOf(2.0f * RADIUS * NODES, 3.0f), 2.0f);
}

TEST(RopeTube, BendsBetweenItsParticles)
{
    // On a circle of 0.3 m chords are inside of it by 0.0107 m in the middle, two and a half pixels; cubics by less
    // than a tenth of that.
    constexpr float CIRCLE = 0.3f, DISTANCE = 1.2f;
    const Image image = drawn(rope(CIRCLE).world, redView({0, 0, DISTANCE}));
    // A ring is seen a little larger than its outer circle: where the tube's sides are tangents from the eye.
    const float outer = pixelsOf(CIRCLE + RADIUS * std::hypot(1.0f, CIRCLE / DISTANCE), DISTANCE);
    for (float angle = -1.5f; angle < 1.55f; angle += 0.05f)
        for (const float beyond : {-1.5f, 1.5f}) {
            const float x = 0.5f * PICTURE + (outer + beyond) * std::sin(angle);
            const float y = 0.5f * PICTURE - (outer + beyond) * std::cos(angle);
            EXPECT_EQ(isRed(image, uint32_t(x), uint32_t(y)), beyond < 0.0f) << angle;
        }
}

TEST(RopeTube, BreaksWhereItIsTorn)
{
    const StillWorld still = rope();
    const RenderSettings settings = redView({0, 0, 3});
    const size_t link = strandOrder(still.world).stateOf(still.world, 0, 3);
    const Image whole = drawnTorn(still.world, settings, {}), broken = drawnTorn(still.world, settings, {link});
    // Between the third and the fourth node, 0.08 m left of the middle; both ends get caps that meet there.
    const auto x = static_cast<uint32_t>(PICTURE / 2 - pixelsOf(RADIUS, 3.0f));
    const auto above = static_cast<uint32_t>(PICTURE / 2 - 0.7f * pixelsOf(RADIUS, 3.0f));
    EXPECT_TRUE(isRed(whole, x, above));
    EXPECT_FALSE(isRed(broken, x, above));
    EXPECT_GT(redPixels(broken), redPixels(whole) * 9 / 10);
}

TEST(RopeTube, ANodeAloneIsABall)
{
    const StillWorld still = rope();
    const StrandOrder order = strandOrder(still.world);
    std::vector<size_t> all;
    for (size_t link = 0; link + 1 < NODES; ++link) all.push_back(order.stateOf(still.world, 0, link));
    const Image image = drawnTorn(still.world, redView({0, 0, 3}), all);
    const float radius = pixelsOf(RADIUS, 3.0f);
    EXPECT_NEAR(float(redPixels(image)), NODES * 3.14159f * radius * radius,
                0.12f * NODES * 3.14159f * radius * radius);
}

TEST(RopeTube, IsNotDrawnWhereItsParticlesAreHidden)
{
    StillWorld still = rope();
    still.world.unseen.push_back({0, NODES});
    EXPECT_EQ(redPixels(drawn(still.world, redView({0, 0, 3}))), 0u);
}

TEST(RopeTube, ShowSpeedsWhereTheyAreAsked)
{
    expectColorsBySpeed(rope().world, 2);
}

}  // namespace
}  // namespace knuckle::test
