#include <cmath>
#include <set>

#include "tests/render/surfaces/matter_fixture.h"

namespace knuckle::test {
namespace {

constexpr float RADIUS = 0.1f;
constexpr int SIDE = 5;

/// Five by five grains, far from each other.
StillWorld grains()
{
    StillWorld still = redMatter(RADIUS);
    for (int j = 0; j < SIDE; ++j)
        for (int k = 0; k < SIDE; ++k) addLoose(still.world, {0.4f * float(k - 2), 0.4f * float(j - 2), 0});
    still.world.drawn.grains.push_back({0, SIDE * SIDE});
    return still;
}

/// Red pixels around each grain.
std::vector<uint32_t> sizesOf(const Image& image)
{
    std::vector<uint32_t> sizes;
    for (int j = 0; j < SIDE; ++j)
        for (int k = 0; k < SIDE; ++k) {
            const auto reach = static_cast<int>(pixelsOf(0.2f, 3.0f));
            const auto x = static_cast<int>(PICTURE / 2 + pixelsOf(0.4f * float(k - 2), 3.0f));
            const auto y = static_cast<int>(PICTURE / 2 - pixelsOf(0.4f * float(j - 2), 3.0f));
            uint32_t count = 0;
            for (int b = -reach; b <= reach; ++b)
                for (int a = -reach; a <= reach; ++a)
                    count += isRed(image, static_cast<uint32_t>(x + a), static_cast<uint32_t>(y + b));
            sizes.push_back(count);
        }
    return sizes;
}

TEST(Grains, AreAsLargeAsTheirParticlesAndNoTwoAreAlike)
{
    const std::vector<uint32_t> sizes = sizesOf(drawn(grains().world, redView({0, 0, 3})));
    const float ball = 3.14159265f * std::pow(pixelsOf(RADIUS, 3.0f), 2.0f);
    float sum = 0.0f;
    for (const uint32_t size : sizes) {
        sum += float(size);
        // The smallest has radii of 0.95, 0.74 and 0.61 with faces at two thirds; the largest of 1.25, 1.25 and 1.1.
        EXPECT_GT(float(size), 0.3f * ball);
        EXPECT_LT(float(size), 1.6f * ball);
    }
    EXPECT_NEAR(sum / SIDE / SIDE, 0.85f * ball, 0.2f * ball);
    EXPECT_GE(std::set<uint32_t>(sizes.begin(), sizes.end()).size(), 15u);
}

TEST(Grains, TurnWhereTheyGo)
{
    StillWorld still = grains();
    const std::vector<uint32_t> before = sizesOf(drawn(still.world, redView({0, 0, 3})));
    for (Particle& particle : still.world.particles) particle.position.z() += 0.1f;
    const std::vector<uint32_t> after = sizesOf(drawn(still.world, redView({0, 0, 3.1f})));
    EXPECT_NE(before, after);
}

TEST(Grains, AreNotDrawnWhereTheyAreHidden)
{
    StillWorld still = grains();
    still.world.unseen.push_back({0, SIDE * SIDE});
    EXPECT_EQ(redPixels(drawn(still.world, redView({0, 0, 3}))), 0u);
}

TEST(Grains, ShowSpeedsWhereTheyAreAsked)
{
    expectColorsBySpeed(grains().world, 2);
}

}  // namespace
}  // namespace knuckle::test
