#include <cmath>

#include "render/stored_view.h"
#include "shared/matter_types.h"
#include "sim/solver/strand/strand_order.h"
#include "tests/render/surfaces/matter_fixture.h"

namespace knuckle::test {
namespace {

constexpr float DIAMETER = 0.1f;
constexpr uint32_t NODES = 9;  // a side

/// A sheet in the plane of the picture, its threads along x and y.
StillWorld sheet()
{
    StillWorld still = redMatter(0.5f * DIAMETER);
    World& world = still.world;
    ClothSurface surface;
    surface.columns = surface.rows = NODES;
    const float middle = 0.5f * (NODES - 1);
    for (uint32_t j = 0; j < NODES; ++j)
        for (uint32_t k = 0; k < NODES; ++k) {
            const float x = DIAMETER * (float(k) - middle), y = DIAMETER * (middle - float(j));
            surface.nodes.push_back(addLoose(world, {x, y, 0}));
        }
    for (uint32_t j = 0; j + 1 < NODES; ++j)
        for (uint32_t k = 0; k + 1 < NODES; ++k) {
            const uint32_t node = j * NODES + k, below = node + NODES;
            surface.triangles.push_back({node, below, node + 1});
            surface.triangles.push_back({node + 1, below, below + 1});
        }
    for (uint32_t line = 0; line < NODES; ++line) {
        std::vector<uint32_t> row, column;
        for (uint32_t k = 0; k < NODES; ++k) {
            row.push_back(surface.nodes[line * NODES + k]);
            column.push_back(surface.nodes[k * NODES + line]);
        }
        addStrand(world, row, DIAMETER);
        addStrand(world, column, DIAMETER);
    }
    world.drawn.cloth.push_back(surface);
    return still;
}

TEST(ClothSurface, HasTheSizeOfItsParticlesAndTheThicknessOfItsHem)
{
    const StillWorld still = sheet();
    // Edges are filtered: a pixel at each end of a length.
    const float side = (NODES - 1 + 2.0f * CLOTH_HALF) * DIAMETER, thickness = 2.0f * CLOTH_HALF * DIAMETER;
    const Image front = drawn(still.world, redView({0, 0, 2}));
    EXPECT_NEAR(redIn(front, PICTURE / 2, true), pixelsOf(side, 2.0f), 2.0f);
    EXPECT_NEAR(redIn(front, PICTURE / 2, false), pixelsOf(side, 2.0f), 2.0f);
    // From beside it the nearest edge is nearer by half the side.
    const Image beside = drawn(still.world, redView({1.2f, 0, 0}));
    EXPECT_NEAR(redIn(beside, PICTURE / 2, true), pixelsOf(thickness, 1.2f - 0.5f * side), 2.0f);
}

TEST(ClothSurface, BothSidesAreLitFromTheirOwn)
{
    const StillWorld still = sheet();
    const auto brightness = [&](float eye, float light) {
        RenderSettings settings = redView({0, 0, eye});
        settings.light.direction = Vector3f(0, 0.1f, light);
        return pixelAt(drawn(still.world, settings), PICTURE / 2, PICTURE / 2).x();
    };
    EXPECT_NEAR(brightness(2, 1), brightness(-2, -1), 3);
    EXPECT_NEAR(brightness(-2, 1), brightness(2, -1), 3);
    EXPECT_GT(brightness(2, 1), brightness(-2, 1) + 30);
}

TEST(ClothSurface, IsASplineThroughItsParticles)
{
    // Rows that alternate by 0.05 m: a cubic B-spline has (4 - 1 - 1) / 6 of that, and nothing sharp.
    StillWorld still = sheet();
    for (uint32_t k = 0; k < NODES * NODES; ++k)
        still.world.particles[k].position.z() = k / NODES % 2 == 0 ? 0.05f : -0.05f;
    const Image beside = drawn(still.world, redView({1.2f, 0, 0}));
    // The rows in the middle, where no edge is folded.
    uint32_t wide = 0;
    for (uint32_t x = 0; x < PICTURE; ++x) {
        bool red = false;
        for (uint32_t y = 60; y < 140; ++y) red = red || isRed(beside, x, y);
        wide += red;
    }
    const float nearest = 1.2f - (0.5f * (NODES - 1) + CLOTH_HALF) * DIAMETER;
    EXPECT_NEAR(float(wide), pixelsOf(2.0f * 0.05f / 3.0f + 2.0f * CLOTH_HALF * DIAMETER, nearest), 2.5f);
}

TEST(ClothSurface, ItsSideIsHalfItsThicknessAboveTheSpline)
{
    StillWorld still = sheet();
    const auto bell = [](float x, float y) { return 0.25f * std::exp(-(x * x + y * y) / 0.06f); };
    for (Particle& p : still.world.particles) p.position.z() = bell(p.position.x(), p.position.y());
    // Its top: 4/6 of the middle's row and 1/6 of each of both beside it, in both directions.
    const auto row = [&](float y) { return (4.0f * bell(0, y) + 2.0f * bell(DIAMETER, y)) / 6.0f; };
    const float top = (4.0f * row(0) + 2.0f * row(DIAMETER)) / 6.0f + CLOTH_HALF * DIAMETER;
    // Left is +z to an eye at +x.
    const Image beside = drawn(still.world, redView({1.2f, 0, 0}));
    uint32_t first = 0;
    while (first < PICTURE && !isRed(beside, first, PICTURE / 2)) ++first;
    EXPECT_NEAR(0.5f * PICTURE - float(first), pixelsOf(top, 1.2f), 1.5f);
}

TEST(ClothSurface, ATearLeavesAHole)
{
    const StillWorld still = sheet();
    const StrandOrder order = strandOrder(still.world);
    // The threads of the middle column of cells, whose rows are every other strand.
    std::vector<size_t> torn;
    for (uint32_t row = 0; row < NODES; ++row) torn.push_back(order.stateOf(still.world, 2 * row, 4));
    const RenderSettings settings = redView({0, 0, 2});
    const Image whole = drawnTorn(still.world, settings, {}), open = drawnTorn(still.world, settings, torn);
    const auto x = static_cast<uint32_t>(PICTURE / 2 + pixelsOf(0.5f * DIAMETER, 2.0f));
    EXPECT_TRUE(isRed(whole, x, PICTURE / 2));
    for (uint32_t y = 0; y < PICTURE; ++y) EXPECT_FALSE(isRed(open, x, y)) << y;
    // A cell is missing from all of the width; what is beside it stays where it was.
    EXPECT_NEAR(float(redIn(whole, PICTURE / 2, true)) - float(redIn(open, PICTURE / 2, true)),
                pixelsOf(DIAMETER, 2.0f), 2.5f);
}

TEST(ClothSurface, ATearIsSeenInStoredStates)
{
    const StillWorld still = sheet();
    const StrandOrder order = strandOrder(still.world);
    ViewState state;
    for (const Particle& p : still.world.particles)
        state.positions.push_back({p.position.x(), p.position.y(), p.position.z(), 0.0f});
    state.velocities.resize(still.world.particles.size());
    state.tornDistances.resize(order.nodeCount);
    std::vector<size_t> torn;
    for (uint32_t row = 0; row < NODES; ++row) {
        torn.push_back(order.stateOf(still.world, 2 * row, 4));
        state.tornDistances[torn.back()] = true;
    }
    const RenderSettings settings = redView({0, 0, 2});
    Renderer renderer(sharedGpu(), still.world, settings);
    StoredView stored(still.world);
    renderer.draw(stored.upload(state), 0.0);
    EXPECT_EQ(renderer.readImage().rgb, drawnTorn(still.world, settings, torn).rgb);
    state.tornDistances.clear();
    renderer.draw(stored.upload(state), 0.0);
    EXPECT_EQ(renderer.readImage().rgb, drawnTorn(still.world, settings, {}).rgb);
}

TEST(ClothSurface, NothingIsPulledAcrossATear)
{
    // The right half has gone away by 0.3 m, and the gap is as wide as between the particles: a spline through all of
    // them would reach into it by a sixth of that from both sides.
    StillWorld still = sheet();
    const StrandOrder order = strandOrder(still.world);
    std::vector<size_t> torn;
    for (uint32_t row = 0; row < NODES; ++row) torn.push_back(order.stateOf(still.world, 2 * row, 4));
    for (Particle& particle : still.world.particles)
        if (particle.position.x() > 0.01f) particle.position.x() += 0.3f;
    const Image image = drawnTorn(still.world, redView({0, 0, 2.5f}), torn);
    const auto y = static_cast<uint32_t>(PICTURE / 2 - pixelsOf(0.05f, 2.5f));
    uint32_t gap = 0;
    for (auto x = static_cast<uint32_t>(PICTURE / 2 - pixelsOf(0.1f, 2.5f)); x < 150; ++x) gap += !isRed(image, x, y);
    EXPECT_NEAR(float(gap), pixelsOf(0.3f + DIAMETER, 2.5f), 2.0f);
}

TEST(ClothSurface, IsNotDrawnWhereItsParticlesAreHidden)
{
    StillWorld still = sheet();
    still.world.unseen.push_back({0, NODES * NODES});
    EXPECT_EQ(redPixels(drawn(still.world, redView({0, 0, 2}))), 0u);
}

TEST(ClothSurface, ShowSpeedsWhereTheyAreAsked)
{
    expectColorsBySpeed(sheet().world, 2);
}

}  // namespace
}  // namespace knuckle::test
