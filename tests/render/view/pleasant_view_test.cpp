#include <cmath>

#include "render/view/pleasant_view.h"
#include "sim/base/angles.h"
#include "tests/render/render_fixture.h"

namespace knuckle::test {
namespace {

/// A body 0.4 m high on the ground, with a wall before it, as high and as far from its middle as told [m].
World behindWall(float height, float distance)
{
    StillWorld still(0.1f);
    still.addGround();
    still.addBody({{-0.3f, 0.05f, -0.3f}, {0.3f, 0.35f, 0.3f}}, {0, 0, 0});
    if (height > 0.0f) {
        Collider& wall = still.addCollider(ColliderShape::Box, {0.0f, 0.5f * height, distance + 0.1f});
        wall.halfExtents = {2.0f, 0.5f * height, 0.1f};
    }
    return still.world;
}

float elevationOf(const World& world)
{
    return std::asin(pleasantDirection(world).y()) / DEGREE;
}

TEST(PleasantView, IsALittleFromAboveWhereNothingIsInTheWay)
{
    EXPECT_NEAR(elevationOf(behindWall(0.0f, 0.0f)), 17.0f, 0.01f);
    EXPECT_NEAR(elevationOf(behindWall(0.2f, 2.0f)), 17.0f, 0.01f);
}

/// Half of what stands behind it is to be seen, 0.45 m high with its particles: from 0.225 m up over a wall of 0.5 m
/// that begins 0.5 m away along z, which is 0.5 m / cos 28 degrees along the view.
TEST(PleasantView, RisesWhereAWallHidesWhatIsBehindIt)
{
    const float needed = std::atan2(0.275f, 0.5f / std::cos(28.0f * DEGREE)) / DEGREE;
    const float found = elevationOf(behindWall(0.5f, 0.5f));
    EXPECT_GE(found, needed);
    EXPECT_LT(found, needed + 1.1f);
}

TEST(PleasantView, StaysLowWhereNoHeightHelps)
{
    EXPECT_NEAR(elevationOf(behindWall(8.0f, 0.5f)), 17.0f, 0.01f);
}

TEST(PleasantView, LooksOverWallsThatAreNotDrawn)
{
    World world = behindWall(0.5f, 0.5f);
    world.colliders.back().visible = false;
    EXPECT_NEAR(elevationOf(world), 17.0f, 0.01f);
}

}  // namespace
}  // namespace knuckle::test
