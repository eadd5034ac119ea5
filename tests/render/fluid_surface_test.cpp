#include <cmath>
#include <numbers>

#include "shared/frame_types.h"
#include "sim/base/random.h"
#include "tests/render/render_fixture.h"

namespace knuckle::test {
namespace {

constexpr float SPACING = 0.04f, DEPTH = 0.5f;
constexpr uint32_t SIZE = 240;
constexpr float FIELD_OF_VIEW = 8.0f, DISTANCE = 6.0f;
constexpr double FLATNESS = 0.66;  // of particles at a surface, over a ball's radius

/// A pool of clear fluid 0.5 m deep, 1.2 m square, on a floor that is black up to x = edge and white beyond.
World pool(float edge, bool wet)
{
    StillWorld still(0.04f);
    World& world = still.world;
    for (const float side : {-1.0f, 1.0f}) {
        Collider& floor = still.addCollider(ColliderShape::Box, {edge + side, -0.1f, 0.0f});
        floor.halfExtents = {1.0f, 0.1f, 3.0f};
        floor.color = side < 0.0f ? Vector3f(0.02f, 0.02f, 0.02f) : Vector3f(0.9f, 0.9f, 0.9f);
    }
    world.fluidSpacing = SPACING;
    world.materials[0].look = {DrawnAs::Surface, 0.0f, 0.0f};
    std::vector<Vector3f> places;
    std::mt19937 random(7);
    const auto jitter = [&] { return 0.2f * SPACING * (uniformFraction(random) - 0.5f); };
    const int across = 30, up = static_cast<int>(std::round(DEPTH / SPACING));
    // Water at rest stands a tenth of its spacing off a lattice.
    for (int z = 0; z < across; ++z)
        for (int y = 0; y < up; ++y)
            for (int x = 0; x < across; ++x) {
                const Vector3f cell(float(x - across / 2), float(y), float(z - across / 2));
                places.emplace_back(SPACING * (cell.array() + 0.5f).matrix() + Vector3f(jitter(), jitter(), jitter()));
            }
    if (wet) addFluid(world, places);
    return world;
}

/// Of the pool's particles, as the solver has them: those at its surface are flat.
std::vector<uint32_t> formsOf(const World& world)
{
    std::vector<uint32_t> forms;
    for (const Particle& p : world.particles)
        forms.push_back(p.position.y() > DEPTH - SPACING ? packedForm({0, 1, 0}, FLATNESS, 1.23) : 0);
    return forms;
}

/// At 45 degrees, along x, at the surface above the origin.
RenderSettings slantedLook()
{
    RenderSettings settings = lookFrom({-DISTANCE * std::sqrt(0.5f), DEPTH + DISTANCE * std::sqrt(0.5f), 0.0f},
                                       {0.0f, DEPTH, 0.0f}, SIZE, SIZE);
    settings.camera.fieldOfView = FIELD_OF_VIEW;
    settings.colorBy = ColorBy::Material;
    return settings;
}

/// The row, from the bottom, at which a column turns from dark to light.
double edgeIn(const Image& image, uint32_t column)
{
    const auto light = [&](uint32_t fromBottom) { return pixelAt(image, column, SIZE - 1 - fromBottom).sum() / 3.0; };
    for (uint32_t row = 0; row + 1 < SIZE; ++row)
        if (light(row) < 120.0 && light(row + 1) >= 120.0)
            return row + 0.5 + (120.0 - light(row)) / (light(row + 1) - light(row));
    return NAN;
}

/// The surface lies above the centres of the topmost particles, which are flat.
const double SURFACE = SPACING * (std::round(DEPTH / SPACING) - 0.5) + FLATNESS * SURFACE_RADIUS * SPACING;
const double FOCAL = 0.5 * SIZE / std::tan(FIELD_OF_VIEW * std::numbers::pi / 360.0);  // [pixels]

/// The row at which a point of the floor is seen through fluid of a refractive index, by Snell's law.
double rowOf(double x, double index)
{
    double low = 0.0, high = SIZE;
    for (int k = 0; k < 60; ++k) {
        const double row = 0.5 * (low + high), tilt = 0.25 * std::numbers::pi - std::atan((row - 0.5 * SIZE) / FOCAL);
        // The ray's angle from the vertical is the complement of its tilt downwards.
        const double angle = 0.5 * std::numbers::pi - tilt, height = DISTANCE * std::sqrt(0.5);
        const double surface = -height + (height + DEPTH - SURFACE) * std::tan(angle);
        const double floor = surface + SURFACE * std::tan(std::asin(std::sin(angle) / index));
        (floor < x ? low : high) = row;
    }
    return 0.5 * (low + high);
}

TEST(FluidSurface, BendsLightAsSnellsLawHasIt)
{
    const float edge = 0.2f;
    const World filled = pool(edge, true);
    const Image dry = drawn(pool(edge, false), slantedLook());
    const Image wet = drawn(filled, slantedLook(), 0.0, formsOf(filled));
    const double middle = SIZE / 2;
    EXPECT_NEAR(edgeIn(dry, SIZE / 2), rowOf(edge, 1.0), 1.0);
    const double shift = rowOf(edge, 1.333) - rowOf(edge, 1.0);
    ASSERT_GT(shift, 20.0);
    double sum = 0.0, squares = 0.0;
    int count = 0;
    for (uint32_t column = 60; column < 180; column += 4, ++count) {
        const double found = edgeIn(wet, column) - edgeIn(dry, column);
        sum += found;
        squares += found * found;
    }
    const double mean = sum / count, deviation = std::sqrt(std::max(squares / count - mean * mean, 0.0));
    // The pixels of the edge are uncertain by half of one.
    EXPECT_NEAR(mean, shift, 0.03 * shift + 0.5) << middle;
    // A slope of the surface shifts what is seen on the floor by 0.35 of the depth times it (Snell at 45 degrees), and
    // bumps of a height are as wide as the filter, some two radii on both sides: slopes are their height over 0.6 of
    // a radius.
    const double metre = SIZE / (2.0 * DISTANCE * std::tan(FIELD_OF_VIEW * std::numbers::pi / 360.0)) * std::sqrt(0.5);
    const double slope = deviation / metre / (0.35 * DEPTH), height = slope * 0.6 * SURFACE_RADIUS * SPACING;
    EXPECT_LT(height, 0.1 * SPACING) << "the surface is not flat: " << deviation << " pixels";
}

constexpr double BALL_RADIUS = 0.12;
const Eigen::Vector3d BALL_CENTRE(0.0, 0.2, 0.0);

/// Whether the ball is seen in a pixel, counted from the bottom, by Snell's law.
bool showsBall(uint32_t column, uint32_t row)
{
    const double half = std::sqrt(0.5), index = 1.333;
    const Eigen::Vector3d eye(-DISTANCE * half, DEPTH + DISTANCE * half, 0.0), forward(half, -half, 0.0);
    const Eigen::Vector3d up(half, half, 0.0), right(0.0, 0.0, 1.0);
    const Eigen::Vector3d way =
        (FOCAL * forward + (column + 0.5 - 0.5 * SIZE) * right + (row + 0.5 - 0.5 * SIZE) * up).normalized();
    const Eigen::Vector3d at = eye + (eye.y() - SURFACE) / -way.y() * way;
    Eigen::Vector3d bent = way / index;
    bent.y() = -std::sqrt(1.0 - bent.x() * bent.x() - bent.z() * bent.z());
    return (BALL_CENTRE - at).cross(bent).norm() < BALL_RADIUS;
}

/// The number of marked pixels of the largest connected region, which is unmarked.
int largestRegion(std::vector<bool> marked)
{
    int largest = 0;
    for (uint32_t start = 0; start < marked.size(); ++start) {
        std::vector<uint32_t> open = {start};
        int count = 0;
        while (!open.empty()) {
            const uint32_t pixel = open.back();
            open.pop_back();
            if (pixel >= marked.size() || !marked[pixel]) continue;
            marked[pixel] = false;
            ++count;
            open.insert(open.end(), {pixel + 1, pixel - 1, pixel + SIZE, pixel - SIZE});
        }
        largest = std::max(largest, count);
    }
    return largest;
}

TEST(FluidSurface, ShowsABallUnderWaterWholeAndWhereSnellsLawHasIt)
{
    World world = pool(0.9f, false);
    Collider ball;
    ball.shape = ColliderShape::Sphere;
    ball.position = BALL_CENTRE.cast<float>();
    ball.radius = float(BALL_RADIUS);
    ball.color = {0.05f, 0.9f, 0.05f};
    world.colliders.push_back(ball);
    std::vector<Vector3f> places;
    for (const Particle& p : pool(0.9f, true).particles) {
        const double away = (p.position.cast<double>() - BALL_CENTRE).norm();
        if (away > BALL_RADIUS + 0.5 * SPACING) places.push_back(p.position);
    }
    addFluid(world, places);
    const Image image = drawn(world, slantedLook(), 0.0, formsOf(world));
    std::vector<bool> green(size_t{SIZE} * SIZE);
    int shown = 0, expected = 0, wrong = 0;
    for (uint32_t y = 0; y < SIZE; ++y)
        for (uint32_t x = 0; x < SIZE; ++x) {
            const Eigen::Vector3i color = pixelAt(image, x, SIZE - 1 - y);
            const bool ballHere = color.y() > color.x() + 40;
            green[size_t{y} * SIZE + x] = ballHere;
            shown += ballHere, expected += showsBall(x, y), wrong += ballHere != showsBall(x, y);
        }
    ASSERT_GT(expected, 2000);
    EXPECT_GT(largestRegion(green), 0.99 * shown) << "the ball is in pieces";
    EXPECT_NEAR(shown, expected, 0.05 * expected);
    EXPECT_LT(wrong, 0.1 * expected);
}

/// What of a picture a drop has changed: its width, its height and how many pixels.
struct Silhouette {
    Silhouette(const Image& with, const Image& without)
    {
        uint32_t low[2] = {SIZE, SIZE}, high[2] = {0, 0};
        for (uint32_t y = 0; y < SIZE; ++y)
            for (uint32_t x = 0; x < SIZE; ++x) {
                if ((pixelAt(with, x, y) - pixelAt(without, x, y)).cwiseAbs().sum() < 30) continue;
                area += 1.0;
                low[0] = std::min(low[0], x), high[0] = std::max(high[0], x);
                low[1] = std::min(low[1], y), high[1] = std::max(high[1], y);
            }
        wide = high[0] - low[0] + 1;
        tall = high[1] - low[1] + 1;
    }
    double wide = 0.0, tall = 0.0, area = 0.0;
};

TEST(FluidSurface, OfADropIsRound)
{
    StillWorld still(0.1f);
    still.world.fluidSpacing = 0.3f;
    still.world.materials[0].look = {DrawnAs::Surface, 0.0f, 1000.0f};
    still.world.materials[0].color = {0.9f, 0.05f, 0.05f};
    RenderSettings settings = lookFrom({0, 0, 1.2f}, {0, 0, 0}, SIZE, SIZE);
    settings.camera.fieldOfView = 30.0f;
    const Image without = drawn(still.world, settings);
    addFluid(still.world, {{0, 0, 0}});
    const Image with = drawn(still.world, settings);
    const auto [wide, tall, area] = Silhouette(with, without);
    const double angle = std::asin(SURFACE_RADIUS * 0.3 / 1.2),
                 scale = 0.5 * SIZE / std::tan(15.0 * std::numbers::pi / 180.0);
    EXPECT_NEAR(wide, 2.0 * scale * std::tan(angle), 0.03 * wide);
    EXPECT_NEAR(wide, tall, 0.03 * wide);
    EXPECT_NEAR(area, 0.25 * std::numbers::pi * wide * tall, 0.03 * area);
}

/// A spheroid that lies across the view. What is spread of a particle within reaches 1.3 radii.
TEST(FluidSurface, OfAStretchedDropIsAsLongAndAsThickAsItsForm)
{
    const double along = 1.15, across = 0.75;
    StillWorld still(0.1f);
    still.world.fluidSpacing = 0.1f;
    still.world.materials[0].look = {DrawnAs::Surface, 0.0f, 1000.0f};
    still.world.materials[0].color = {0.9f, 0.05f, 0.05f};
    RenderSettings settings = lookFrom({0, 0, 2.4f}, {0, 0, 0}, SIZE, SIZE);
    settings.camera.fieldOfView = 5.0f;
    const Image without = drawn(still.world, settings);
    addFluid(still.world, {{0, 0, 0}});
    const Image with = drawn(still.world, settings, 0.0, {packedForm({1, 0, 0}, along, across)});
    const auto [wide, tall, area] = Silhouette(with, without);
    const double pixels = SURFACE_RADIUS * 0.1 * SIZE / (2.4 * std::tan(2.5 * std::numbers::pi / 180.0));
    EXPECT_NEAR(wide, along * pixels, 0.03 * wide);
    EXPECT_NEAR(tall, across * pixels, 0.03 * tall);
}

/// Mean colours of the left and the right half of the picture's middle.
std::pair<Eigen::Vector3d, Eigen::Vector3d> halves(const Image& image)
{
    Eigen::Vector3d left(0, 0, 0), right(0, 0, 0);
    for (uint32_t y = 100; y < 140; ++y)
        for (uint32_t x = 0; x < 30; ++x) {
            left += pixelAt(image, 80 + x, y).cast<double>() / 1200.0;
            right += pixelAt(image, 130 + x, y).cast<double>() / 1200.0;
        }
    return {left, right};
}

TEST(FluidSurface, OfTwoFluidsHasTheColourOfEachAndBeadsStaySpheres)
{
    World world = pool(-10.0f, true);
    world.materials[0].look = {DrawnAs::Surface, 5.0f, 0.0f};
    world.materials[0].color = {0.02f, 0.3f, 0.9f};
    world.materials[1].look = {DrawnAs::Surface, 5.0f, 0.0f};
    world.materials[1].color = {0.9f, 0.3f, 0.02f};
    for (Particle& p : world.particles) p.material = p.position.z() > 0.0f ? 1 : 0;
    RenderSettings settings = slantedLook();
    const auto [cold, warm] = halves(drawn(world, settings));
    EXPECT_GT(cold.z(), cold.x() + 60.0);
    EXPECT_GT(warm.x(), warm.z() + 60.0);
    world.materials[1].look.drawn = DrawnAs::Particles;
    const Image mixed = drawn(world, settings);
    settings.colorBy = ColorBy::Particle;
    EXPECT_NE(drawn(world, settings).rgb, mixed.rgb) << "particles' own colours are shown on particles";
    EXPECT_GT(halves(mixed).first.z(), halves(mixed).first.x() + 60.0);
}

TEST(FluidSurface, IsHiddenByWhatStandsInFront)
{
    World world = pool(-10.0f, true);
    world.materials[0].look = {DrawnAs::Surface, 5.0f, 0.0f};
    const RenderSettings settings = slantedLook();
    Collider wall;
    wall.shape = ColliderShape::Box;
    wall.position = {-1.5f, 1.5f, 0.0f};
    wall.halfExtents = {0.05f, 1.5f, 1.5f};
    wall.color = {0.9f, 0.02f, 0.02f};
    world.colliders.push_back(wall);
    const Image image = drawn(world, settings);
    const Eigen::Vector3i middle = pixelAt(image, SIZE / 2, SIZE / 2);
    EXPECT_GT(middle.x(), middle.z() + 60);
}

}  // namespace
}  // namespace knuckle::test
