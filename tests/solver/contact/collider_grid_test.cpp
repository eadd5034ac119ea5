#include <cmath>

#include "sim/world/collider_distance.h"
#include "tests/solver/contact/collider_world.h"

namespace knuckle::test {

namespace {

/// Random values, within about 0.4 m: no shape, but all kernels must read them alike.
ColliderGrid randomGrid(Random& random)
{
    ColliderGrid grid;
    grid.counts = {6, 5, 7};
    grid.cell = Vector3f::Constant(0.07f);
    grid.low = {-0.2f, -0.15f, -0.25f};
    for (int i = 0; i < grid.counts.prod(); ++i) grid.values.push_back(random.between(-0.1f, 0.3f));
    return grid;
}

ColliderGrid randomField(Random& random)
{
    std::vector<float> heights;
    for (int i = 0; i < 8 * 5; ++i) heights.push_back(random.between(-0.1f, 0.1f));
    return makeHeightfield({0.7f, 0.5f}, 8, 5, heights);
}

World gridWorld()
{
    World world = mixedWorld();
    Random random(61);
    world.colliderGrids = {randomField(random), randomGrid(random)};
    for (uint32_t grid : {0u, 1u}) {
        const ColliderShape shape = grid == 0 ? ColliderShape::Heightfield : ColliderShape::Mesh;
        world.colliders.push_back(colliderOf(shape, random.inCube(0.1f), random.rotation()));
        world.colliders.back().grid = grid;
    }
    return world;
}

TEST(ColliderGrid, TheKernelsSeeTheDistanceOfTheReferenceAndItsGradient)
{
    writeColliderKernel();
    KernelFixture fixture(gridWorld());
    EXPECT_TRUE(fixture.stages.layout.hasGrids);
    const auto positions = randomVectors(fixture.world.particles.size(), 0.5f, 62);
    fill(fixture.stages.particles.positions, positions);
    const Kernel kernel = fixture.load("test_collider", {{"GRIDS", "1"}});
    for (uint32_t c = 0; c < fixture.world.colliders.size(); ++c) {
        SCOPED_TRACE("collider " + std::to_string(c));
        glProgramUniform1ui(kernel.program(), 0, c);
        fixture.dispatch(kernel, groupsFor(positions.size()));
        const auto results = fixture.stages.particles.velocities.download();
        const Collider& collider = fixture.world.colliders[c];
        const auto distance = [&](const Vector3f& x) { return colliderDistance(fixture.world, collider, x); };
        uint32_t smooth = 0, checked = 0;
        for (size_t i = 0; i < positions.size(); ++i) {
            const Vector3f x = vec3(positions[i]), normal = vec3(results[i]);
            // Places off by 1e-7 m on slopes of up to 0.4 over a cell of 0.07.
            ASSERT_NEAR(results[i].w, distance(x), 1e-5f) << "particle " << i;
            ASSERT_NEAR(normal.norm(), 1.0f, 1e-5f) << "particle " << i;
            const ColliderGrid& grid = fixture.world.colliderGrids[collider.grid];
            const Vector3f p = collider.orientation.conjugate() * (x - collider.position) - grid.low;
            const Vector3f size = grid.cell.cwiseProduct((grid.counts.array() - 1).cast<float>().matrix());
            const bool field = c == 0;
            if (p.x() < 0 || p.z() < 0 || p.x() > size.x() || p.z() > size.z()) continue;
            if (!field && (p.y() < 0 || p.y() > size.y())) continue;
            ++checked;
            // No other direction leads up as steeply, except where a step crosses into the next cell.
            const float up = distance(x + 0.0005f * normal) - distance(x - 0.0005f * normal);
            const Vector3f aside = (normal + 0.5f * normal.unitOrthogonal()).normalized();
            smooth += up >= distance(x + 0.0005f * aside) - distance(x - 0.0005f * aside) - 1e-6f;
        }
        EXPECT_GT(checked, 20u);
        // A heightfield's normal is that of the plane; its distance curves with the surface.
        EXPECT_GT(smooth, (c == 0 ? 0.5 : 0.85) * checked);
    }
    gpu().checkErrors();
}

TEST(ColliderGrid, AHeightfieldIsSolidBelowAndEndsInWalls)
{
    const ColliderGrid grid = makeHeightfield({2, 2}, 3, 2, {0, 1, 2, 0, 1, 2});  // a slope of 45 degrees
    EXPECT_NEAR(heightfieldDistance(grid, {0, 2, 0}), std::sqrt(0.5f), 1e-6f);
    EXPECT_NEAR(heightfieldDistance(grid, {0.5f, -3, 0.3f}), -4.5f * std::sqrt(0.5f), 1e-5f);
    EXPECT_NEAR(heightfieldDistance(grid, {1.5f, -7, 0}), 0.5f, 1e-6f) << "beside it";
    EXPECT_NEAR(heightfieldDistance(grid, {1.3f, 2.4f, 0}), 0.5f, 1e-6f) << "off its upper edge: 3-4-5";
}

}  // namespace

}  // namespace knuckle::test
