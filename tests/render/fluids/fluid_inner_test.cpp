#include "sim/solver/measure/spheroid.h"
#include "tests/render/render_fixture.h"

namespace knuckle::test {
namespace {

constexpr float SPACING = 0.1f;
constexpr int SIDE = 9;

/// A block of opaque fluid.
World block()
{
    StillWorld still(0.1f);
    still.addGround();
    World& world = still.world;
    world.fluidSpacing = SPACING;
    world.materials[0].look = {DrawnAs::Surface, 20.0f, 5.0f};
    world.materials[0].color = {0.1f, 0.4f, 0.8f};
    std::vector<Vector3f> places;
    for (int i = 0; i < SIDE * SIDE * SIDE; ++i)
        places.push_back(SPACING * Vector3f(float(i % SIDE), float(i / SIDE % SIDE), float(i / (SIDE * SIDE))));
    addFluid(world, places);
    return world;
}

/// Balls, but for those behind so many layers.
std::vector<uint32_t> formsBehind(int layers)
{
    std::vector<uint32_t> forms;
    for (int i = 0; i < SIDE * SIDE * SIDE; ++i) {
        const int x = i % SIDE, y = i / SIDE % SIDE, z = i / (SIDE * SIDE);
        const int layer = std::min({x, y, z, SIDE - 1 - x, SIDE - 1 - y, SIDE - 1 - z});
        forms.push_back(layer >= layers ? INNER : 0);
    }
    return forms;
}

TEST(FluidInner, ParticlesAreLeftOutAndNobodySeesIt)
{
    World world = block();
    const RenderSettings settings = lookFrom({2.2f, 1.9f, 2.6f}, {0.4f, 0.3f, 0.4f}, 200, 150);
    const Image all = drawn(world, settings, 0.0, formsBehind(SIDE));
    EXPECT_EQ(drawn(world, settings, 0.0, formsBehind(1)).rgb, all.rgb);
    EXPECT_NE(drawn(world, settings, 0.0, formsBehind(0)).rgb, all.rgb) << "none is drawn";
    // As spheres they have gaps.
    world.materials[0].look.drawn = DrawnAs::Particles;
    EXPECT_EQ(drawn(world, settings, 0.0, formsBehind(0)).rgb, drawn(world, settings, 0.0, formsBehind(SIDE)).rgb);
}

TEST(FluidInner, FluidThatIsNotToBeSeenIsNotDrawn)
{
    World world = block(), dry = world;
    dry.particles.clear();
    dry.fluidCount = 0;
    const RenderSettings settings = lookFrom({2.2f, 1.9f, 2.6f}, {0.4f, 0.3f, 0.4f}, 200, 150);
    const Image without = drawn(dry, settings);
    EXPECT_NE(drawn(world, settings).rgb, without.rgb);
    const auto count = static_cast<uint32_t>(world.particles.size());
    world.unseen = {{0, count}};
    EXPECT_EQ(drawn(world, settings).rgb, without.rgb);
    world.unseen = {{0, count / 2}};
    World half = world;
    half.unseen.clear();
    half.particles.erase(half.particles.begin(), half.particles.begin() + count / 2);
    half.fluidCount -= count / 2;
    EXPECT_EQ(drawn(world, settings).rgb, drawn(half, settings).rgb);
    world.materials[0].look.drawn = DrawnAs::Particles;
    world.unseen = {{0, count}};
    EXPECT_EQ(drawn(world, settings).rgb, without.rgb) << "as spheres";
}

}  // namespace
}  // namespace knuckle::test
