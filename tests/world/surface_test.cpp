#include <gtest/gtest.h>

#include "sim/world/builder/builder.h"

namespace knuckle {
namespace {

constexpr float DIAMETER = 0.1f;

TEST(Surface, ABoxLatticeHasTheDistancesOfItsBoxWhereverItStands)
{
    std::vector<Vector3f> positions = boxLattice({5, 3, 4}, DIAMETER);
    for (Vector3f& position : positions) position += Vector3f(1, -2, 3);
    const auto surfaces = latticeSurface(positions, DIAMETER);
    ASSERT_EQ(surfaces.size(), positions.size());
    for (size_t i = 0; i < positions.size(); ++i) {
        const Vector3f p = positions[i] - Vector3f(1, -2, 3), half(0.25f, 0.15f, 0.2f);
        // Rounding of positions of a few metres in single precision.
        EXPECT_NEAR(surfaces[i].distance, (p.cwiseAbs() - half).maxCoeff(), 2e-6f);
    }
    EXPECT_LT((surfaces[0].outward - Vector3f(-1, -1, -1).normalized()).norm(), 1e-6f) << "a corner";
    EXPECT_LT((surfaces[2].outward - Vector3f(0, -1, -1).normalized()).norm(), 1e-6f) << "an edge";
    EXPECT_LT((surfaces[7].outward - Vector3f(0, 0, -1)).norm(), 1e-6f) << "a face";
    EXPECT_EQ(surfaces[0].ends, 0b010101u) << "a corner";
    EXPECT_EQ(surfaces[2].ends, 0b010100u) << "an edge";
    EXPECT_EQ(surfaces[7].ends, 0b010000u) << "a face";
    EXPECT_EQ(surfaces[22].ends, 0u) << "inside";
    EXPECT_EQ(surfaces[59].ends, 0b101010u) << "the last corner";
}

TEST(Surface, ASingleLayerHasNoWayOutAcross)
{
    for (const SurfaceDistance& surface : latticeSurface(boxLattice({5, 1, 5}, DIAMETER), DIAMETER))
        EXPECT_EQ(surface.outward.y(), 0.0f);
    for (const SurfaceDistance& surface : latticeSurface(boxLattice({5, 1, 5}, DIAMETER), DIAMETER))
        EXPECT_EQ(surface.ends & 0b1100u, 0b1100u) << "both of its sides are faces";
}

TEST(Surface, WhatIsNoBoxLatticeHasNone)
{
    std::vector<Vector3f> positions = boxLattice({3, 3, 3}, DIAMETER);
    positions.pop_back();
    EXPECT_TRUE(latticeSurface(positions, DIAMETER).empty());
    EXPECT_TRUE(latticeSurface({}, DIAMETER).empty());
    // A wedge of as many particles as the box around it.
    std::vector<Vector3f> wedge = boxLattice({4, 3, 3}, DIAMETER);
    for (Vector3f& position : wedge) position.x() *= 1.0f + 0.5f * position.y();
    EXPECT_TRUE(latticeSurface(wedge, DIAMETER).empty());
    std::vector<Vector3f> stretched = boxLattice({4, 3, 3}, DIAMETER);
    for (Vector3f& position : stretched) position.x() *= 1.1f;
    EXPECT_EQ(latticeSurface(stretched, DIAMETER).size(), stretched.size());
}

TEST(Surface, ACapsulesDistanceIsThatToItsAxis)
{
    const SurfaceDistance side = capsuleSurface({0.3f, 0.1f, 0.4f}, 1.0f, 0.5f);
    EXPECT_NEAR(side.distance, -0.5f, 1e-6f);
    EXPECT_LT((side.outward - Vector3f(0.6f, 0, 0.8f)).norm(), 1e-6f);
    EXPECT_NEAR(capsuleSurface({0, 1.0f, 0}, 1.0f, 0.5f).distance, -0.5f, 1e-6f) << "in a cap";
    EXPECT_EQ(capsuleSurface({0, 0.2f, 0}, 1.0f, 0.5f).outward, Vector3f(0, 0, 0)) << "on the axis";
}

TEST(Surface, TheBuilderKeepsWhatItIsGivenAndKnowsBoxes)
{
    WorldBuilder builder(DIAMETER / 2);
    builder.addMaterial({});
    builder.beginObject("box");
    builder.addBody("box", boxLattice({2, 2, 2}, DIAMETER), 0);
    builder.endObject();
    const std::vector<Vector3f> two = {{0, 1, 0}, {0.1f, 1.1f, 0}};
    const std::vector<SurfaceDistance> given = {{-0.3f, {0, 1, 0}}, {0.2f, {1, 0, 0}}};
    builder.beginObject("given");
    builder.addBody("given", two, 0, Motion::Dynamic, given);
    builder.endObject();
    const World world = builder.build();
    EXPECT_NEAR(world.particles[0].surface.distance, -0.05f, 1e-6f);
    EXPECT_EQ(world.particles[8].surface.distance, -0.3f);
    EXPECT_EQ(world.particles[9].surface.outward, Vector3f(1, 0, 0));
}

}  // namespace
}  // namespace knuckle
