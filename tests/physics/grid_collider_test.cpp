#include <cmath>

#include "sim/rig/mesh/distance_grid.h"
#include "tests/physics/physics_fixture.h"

namespace knuckle::test {

namespace {

/// A world of one body of `positions` over a collider with this grid.
World over(ColliderShape shape, ColliderGrid grid, std::span<const Vector3f> positions, const Vector3f& place,
           float friction)
{
    WorldBuilder builder = makeBuilder({}, friction);
    Collider collider;
    collider.shape = shape;
    collider.staticFriction = collider.kineticFriction = friction;
    collider.grid = builder.addColliderGrid(std::move(grid));
    builder.addCollider(collider);
    builder.beginObject("body");
    builder.addBody("body", positions, 0);
    builder.endObject({place});
    return builder.build();
}

/// The cube of edge 2 about the origin.
ColliderGrid cubeGrid()
{
    std::vector<Vector3f> vertices;
    for (int i = 0; i < 8; ++i) vertices.emplace_back(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
    const std::vector<Triangle> triangles = {{0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}, {0, 1, 5}, {0, 5, 4},
                                             {0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {2, 6, 7}, {2, 7, 3}};
    return makeDistanceGrid(vertices, triangles, DIAMETER);
}

}  // namespace

TEST(GridCollider, ABallRestsOnAMesh)
{
    const World world = over(ColliderShape::Mesh, cubeGrid(), sphereLattice(0.25f, DIAMETER), {0.1f, 1.4f, 0.05f},
                             0.5f);
    Solver solver(gpu(), world);
    run(solver, world, 6.0);  // it stays on a facet for a while
    const BodyState ball = solver.readBodies()[0];
    // The hull of its lattice has faces such as that of (2, 0, 0), (1, 1, 1) and (1, 1, -1) diameters, at the square
    // root of 2 from its centre; their particles' centres are half a diameter above the mesh.
    EXPECT_NEAR(ball.position.y(), 1.0f + (std::sqrt(2.0f) + 0.5f) * DIAMETER, 0.006f * DIAMETER);  // measured 7e-4
    EXPECT_LT(ball.velocity.norm(), 6e-4f);                                                         // measured 8e-5
    EXPECT_LT(solver.measure().worstPenetration, 0.006f * DIAMETER);                                // measured 8e-4
}

/// Its centre is outside the mesh's grid, which ends a cell beyond the mesh.
TEST(GridCollider, ALargeBallRestsOnAMeshByItsOwnRadius)
{
    const RoundShape round{0.3f, 0.0f};
    const std::vector<Vector3f> places = sphereLattice(round.radius, DIAMETER);
    std::vector<SurfaceDistance> surface;
    for (const Vector3f& place : places) surface.push_back(capsuleSurface(place, round.radius, 0.0f));
    WorldBuilder builder = makeBuilder();
    Collider collider;
    collider.shape = ColliderShape::Mesh;
    collider.grid = builder.addColliderGrid(cubeGrid());
    builder.addCollider(collider);
    builder.beginObject("ball");
    builder.addBody("ball", places, 0, Motion::Dynamic, surface, round);
    builder.endObject({{0.1f, 1.35f, 0.05f}});
    const World world = builder.build();
    Solver solver(gpu(), world);
    run(solver, world, 2.0);
    const BodyState ball = solver.readBodies()[0];
    EXPECT_NEAR(ball.position.y(), 1.3f, 0.006f * DIAMETER);
    EXPECT_LT(ball.velocity.norm(), 1e-3f);
}

TEST(GridCollider, ABlockSlidesDownAHeightfieldAsOnAPlane)
{
    // 20 degrees, no friction: g sin(20) t^2 / 2 along the slope.
    const float slope = std::tan(20.0f * static_cast<float>(M_PI) / 180.0f);
    std::vector<float> heights;
    for (int z = 0; z < 5; ++z)
        for (int x = 0; x < 9; ++x) heights.push_back(slope * static_cast<float>(x));
    const float up = 4.0f * slope;  // at the origin
    const World world = over(ColliderShape::Heightfield, makeHeightfield({8, 4}, 9, 5, heights),
                             boxLattice({5, 3, 5}, DIAMETER), {2.5f, up + 2.5f * slope + 0.28f, 0}, 0.0f);
    Solver solver(gpu(), world);
    run(solver, world, 0.3);  // lands and tilts
    const BodyState before = solver.readBodies()[0];
    run(solver, world, 0.7);
    const BodyState after = solver.readBodies()[0];
    const double angle = std::atan(static_cast<double>(slope));
    const double wanted = -0.7 * GRAVITY * std::sin(angle) * std::cos(angle);
    EXPECT_NEAR(after.velocity.x() - before.velocity.x(), wanted, 0.0015 * std::abs(wanted));  // measured 1.9e-4
    EXPECT_NEAR(after.position.z(), 0.0f, 1e-5f);                                              // measured 0
}

}  // namespace knuckle::test
