#include <cmath>
#include <memory>

#include "tests/render/surfaces/matter_fixture.h"

namespace knuckle::test {
namespace {

constexpr float DIAMETER = 0.1f;

/// A soft cube of six particles a side with a hull of flat faces, all of it moved.
template <typename Move>
StillWorld softCube(Move move)
{
    StillWorld still = redMatter(0.5f * DIAMETER);
    const std::vector<Vector3f> rest = cubeLattice(6, DIAMETER);
    for (const Vector3f& place : rest) addLoose(still.world, move(place));
    std::vector<Vector3f> corners;
    for (int k = 0; k < 8; ++k)
        corners.push_back(3.0f * DIAMETER * Vector3f(k & 1 ? 1.f : -1.f, k & 2 ? 1.f : -1.f, k & 4 ? 1.f : -1.f));
    auto hull = std::make_shared<SoftHull>();
    hull->vertices = bindHull(corners, rest, 0.8f * DIAMETER);
    hull->triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                       {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    SoftBody body;
    body.particleCount = static_cast<uint32_t>(rest.size());
    still.world.softBodies.push_back(body);
    still.world.drawn.soft.push_back({0, hull});
    return still;
}

TEST(SoftSurface, GoesWithEveryStretchOfItsParticles)
{
    // Wide and low; its front face is at z = 0.3 m. The fit gives way by a thousandth: a pixel for filtered edges.
    const auto stretch = [](const Vector3f& p) { return Vector3f(1.5f * p.x(), 0.6f * p.y(), p.z()); };
    const Image image = drawn(softCube(stretch).world, redView({0, 0, 2.5f}));
    EXPECT_NEAR(float(redIn(image, PICTURE / 2, true)), pixelsOf(0.9f, 2.2f), 2.0f);
    EXPECT_NEAR(float(redIn(image, PICTURE / 2, false)), pixelsOf(0.36f, 2.2f), 2.0f);
}

TEST(SoftSurface, HidesItsParticlesAndIsHiddenWithThem)
{
    const auto stay = [](const Vector3f& p) { return p; };
    StillWorld still = softCube(stay);
    // The corner of the front face, between a cube's and the outermost sphere's.
    const auto at = static_cast<uint32_t>(PICTURE / 2 + pixelsOf(0.29f, 2.2f));
    EXPECT_TRUE(isRed(drawn(still.world, redView({0, 0, 2.5f})), at, at));
    still.world.unseen.push_back({0, static_cast<uint32_t>(still.world.particles.size())});
    EXPECT_EQ(redPixels(drawn(still.world, redView({0, 0, 2.5f}))), 0u);
}

TEST(SoftSurface, ABoundPlaceFollowsTurnsAndShears)
{
    const std::vector<Vector3f> rest = cubeLattice(5, DIAMETER);
    const std::vector<Vector3f> places{{0.25f, 0.25f, 0.25f}, {0.25f, 0.03f, -0.1f}, {0.0f, -0.28f, 0.07f}};
    Eigen::Matrix3f map = Eigen::AngleAxisf(1.0f, Vector3f(1, 2, 3).normalized()).toRotationMatrix();
    map.col(0) += 0.4f * map.col(1);
    const std::vector<HullVertex> bound = bindHull(places, rest, 0.8f * DIAMETER);
    for (size_t v = 0; v < places.size(); ++v) {
        Vector3f place = Vector3f::Zero();
        float sum = 0.0f;
        for (size_t k = 0; k < HULL_LINKS; ++k) {
            place += bound[v].weights[k] * (map * rest[bound[v].particles[k]]);
            sum += bound[v].weights[k];
        }
        // The resistance of the fit, a thousandth of the square of the reach, against moments of a tenth of it or
        // more: a hundredth of the way from the particles' mean, which is a diameter at most.
        EXPECT_LT((place - map * places[v]).norm(), 0.01f * DIAMETER) << v;
        EXPECT_NEAR(sum, 1.0f, 1e-5f);
    }
}

TEST(SoftSurface, ShowSpeedsWhereTheyAreAsked)
{
    expectColorsBySpeed(softCube([](const Vector3f& p) { return p; }).world, 2);
}

}  // namespace
}  // namespace knuckle::test
