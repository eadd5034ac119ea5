#include <numbers>

#include "tests/world/world_fixture.h"

namespace knuckle::test {

namespace {

/// The least distance between two points, which is the spacing of the lattice.
float spacing(const std::vector<Vector3f>& points)
{
    float nearest = 1e9f;
    for (size_t i = 0; i < points.size(); ++i)
        for (size_t k = 0; k < i; ++k) nearest = std::min(nearest, (points[i] - points[k]).norm());
    return nearest;
}

Vector3f mean(const std::vector<Vector3f>& points)
{
    Vector3f sum = Vector3f::Zero();
    for (const Vector3f& p : points) sum += p;
    return sum / static_cast<float>(points.size());
}

}  // namespace

TEST(Lattice, ABoxHasItsCountsAndExtentAndIsCentred)
{
    const auto points = boxLattice({4, 3, 2}, DIAMETER);
    ASSERT_EQ(points.size(), 24u);
    Vector3f low = points[0], high = points[0];
    for (const Vector3f& p : points) {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
    }
    EXPECT_LT((high - DIAMETER * Vector3f(1.5f, 1.0f, 0.5f)).norm(), 1e-6f);
    EXPECT_LT((low + high).norm(), 1e-6f);
    EXPECT_NEAR(spacing(points), DIAMETER, 1e-6f);
    EXPECT_LT(mean(points).norm(), 1e-6f);
}

TEST(Lattice, ASphereHoldsExactlyTheLatticePointsWhoseParticlesLieInIt)
{
    // Radius 2.5 diameters: particle centres up to 2 diameters out. Points of Z^3 with norm <= 2: 33.
    const auto points = sphereLattice(2.5f * DIAMETER, DIAMETER);
    EXPECT_EQ(points.size(), 33u);
    for (const Vector3f& p : points) EXPECT_LE(p.norm(), 2.0f * DIAMETER * 1.001f);
    EXPECT_NEAR(spacing(points), DIAMETER, 1e-6f);
    EXPECT_LT(mean(points).norm(), 1e-6f);
}

TEST(Lattice, ASphereNoLargerThanAParticleIsOneParticle)
{
    EXPECT_EQ(sphereLattice(0.5f * DIAMETER, DIAMETER).size(), 1u);
    EXPECT_EQ(sphereLattice(0.1f * DIAMETER, DIAMETER).size(), 1u);
}

TEST(Lattice, ACapsuleWithoutHeightIsASphere)
{
    EXPECT_EQ(capsuleLattice(2.5f * DIAMETER, 0.0f, DIAMETER).size(), 33u);
}

TEST(Lattice, ACapsuleIsASphereWithAShaft)
{
    // Each layer of the shaft is the sphere's middle layer: 13 points of Z^2 with norm <= 2. A half height of 3
    // diameters splits the sphere at its middle and inserts 6 more layers there.
    const auto points = capsuleLattice(2.5f * DIAMETER, 3.0f * DIAMETER, DIAMETER);
    EXPECT_EQ(points.size(), 33u + 6u * 13u);
    for (const Vector3f& p : points) {
        EXPECT_LE(std::abs(p.y()), 5.0f * DIAMETER * 1.001f);
        EXPECT_LE(std::hypot(p.x(), p.z()), 2.0f * DIAMETER * 1.001f);
    }
    EXPECT_LT(mean(points).norm(), 1e-6f);
}

TEST(Lattice, AFineSphereHasTheVolumeOfItsParticles)
{
    // Points within a radius R of n diameters: 4/3 pi n^3, off by the lattice points near the surface. In
    // Gauss's circle problem for balls that is below 2 % at n = 12.
    const auto points = sphereLattice(12.5f * DIAMETER, DIAMETER);
    const double ball = 4.0 / 3.0 * std::numbers::pi * 12.0 * 12.0 * 12.0;
    EXPECT_NEAR(static_cast<double>(points.size()) / ball, 1.0, 0.02);
}

}  // namespace knuckle::test
