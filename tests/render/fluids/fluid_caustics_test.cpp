#include <cmath>
#include <numbers>

#include "shared/frame_types.h"
#include "tests/render/render_fixture.h"

namespace knuckle::test {
namespace {

constexpr float SPACING = 0.04f, DEPTH = 0.48f, HEIGHT = 0.03f, LENGTH = 0.6f, WAVE = 2.0f * 3.14159265f / LENGTH;
constexpr uint32_t SIZE = 240;
constexpr float SLANT = 0.26f;  // of the sun, along the crests

/// A pool of clear fluid, 1.2 m square, on a white floor. Its surface is a wave along x with a crest at 0.
World wavyPool(float height)
{
    StillWorld still(0.04f);
    World& world = still.world;
    Collider& floor = still.addCollider(ColliderShape::Box, {0.0f, -0.1f, 0.0f});
    floor.halfExtents = {0.6f, 0.1f, 0.6f};
    floor.color = {0.5f, 0.5f, 0.5f};
    world.fluidSpacing = SPACING;
    world.materials[0].look = {DrawnAs::Surface, 0.0f, 0.0f};
    std::vector<Vector3f> places;
    for (int z = -15; z < 15; ++z)
        for (int x = -15; x < 15; ++x) {
            const float along = (static_cast<float>(x) + 0.5f) * SPACING;
            const float top = DEPTH + height * std::cos(WAVE * along);
            for (int y = 0; y < 11; ++y)
                places.emplace_back(along, top - static_cast<float>(y) * SPACING,
                                    (static_cast<float>(z) + 0.5f) * SPACING);
        }
    addFluid(world, places);
    return world;
}

/// Lit by the sun alone, from straight above.
RenderSettings sunlitLook()
{
    RenderSettings settings = lookFrom({0, 8, 0.001f}, {0, 0, 0}, SIZE, SIZE);
    settings.camera.fieldOfView = 6.0f;
    settings.colorBy = ColorBy::Material;
    settings.toneMap = ToneMap::Linear;
    settings.light.direction = {0.0f, 1.0f, std::tan(SLANT)};
    settings.light.softness = 0.0f;
    settings.light.skyColor = settings.light.groundColor = {0, 0, 0};
    return settings;
}

/// The light of the floor under a point, the mean along the crests.
double lightAt(const Image& image, float x)
{
    const double metre = SIZE / (2.0 * 8.0 * std::tan(3.0 * std::numbers::pi / 180.0));
    const auto column = static_cast<uint32_t>(std::lround(0.5 * SIZE + metre * x));
    double sum = 0.0;
    for (uint32_t row = SIZE / 3; row < 2 * SIZE / 3; ++row)
        sum += std::pow(pixelAt(image, column, row).x() / 255.0, 2.2);
    return sum;
}

/// The height towards the sun of what it sees at a place of its picture: the nearest of the discs that particles are.
double heightSeen(double x, double y)
{
    const double cosine = std::cos(SLANT), sine = std::sin(SLANT);
    double nearest = -1.0;
    const int column = static_cast<int>(std::floor(x / SPACING)), row = static_cast<int>(std::floor(y / SPACING));
    for (int k = column - 2; k <= column + 2; ++k)
        for (int r = row - 20; r <= row + 20; ++r) {
            const double along = (k + 0.5) * SPACING, z = (r + 0.5) * SPACING;
            const double top = DEPTH + HEIGHT * std::cos(WAVE * along);
            if (std::hypot(along - x, z * cosine - top * sine - y) < SURFACE_RADIUS * SPACING)
                nearest = std::max(nearest, top * cosine + z * sine);
        }
    return nearest;
}

/// How the surface is bent there along the wave [1/m], as seen through a Gaussian that is 1.2 spacings wide. Above 0 at
/// crests.
double bentAt(double x)
{
    const auto topAt = [](double place) {
        double sum = 0.0;
        for (int k = 0; k < 20; ++k) sum += heightSeen(place, 0.05 * k * SPACING * std::cos(SLANT)) / 20.0;
        return sum;
    };
    const double width = 1.2 * SPACING, step = 0.01 * SPACING;
    double sum = 0.0, weights = 0.0;
    for (int k = -300; k <= 300; ++k) {
        const double off = step * k, q = off / width, weight = std::exp(-0.5 * q * q);
        sum += weight * (1.0 - q * q) / (width * width) * (topAt(x + off) - topAt(x));
        weights += weight;
    }
    return sum / weights;
}

TEST(FluidCaustics, WavesGatherLightAsTheirCurvatureHasIt)
{
    const Image wavy = drawn(wavyPool(HEIGHT), sunlitLook()), flat = drawn(wavyPool(0.0f), sunlitLook());
    // Behind a surface of the curvature c, light that has gone the way w is spread by 1 - (1 - 1/n) w c. The sun's way
    // is longer by its slant, and so is what it sees of the wave's height.
    const double cosine = std::cos(SLANT), bending = 0.25 / cosine / cosine;
    const double crest = 1.0 / (1.0 - bending * (DEPTH + HEIGHT) * bentAt(0.0));
    const double trough = 1.0 / (1.0 - bending * (DEPTH - HEIGHT) * bentAt(0.5 * LENGTH));
    EXPECT_GT(crest, 1.2);
    EXPECT_LT(trough, 0.85);
    // Pixels hold light to a hundredth, and particles stand on texels of the light's map to a fifth of their radius.
    EXPECT_NEAR(lightAt(wavy, 0.0f) / lightAt(flat, 0.0f), crest, 0.04 * crest);
    EXPECT_NEAR(lightAt(wavy, 0.5f * LENGTH) / lightAt(flat, 0.5f * LENGTH), trough, 0.04 * trough);
}

/// Two halves of a slab dim other colours, as much as they are thick and no more for the air below them.
TEST(FluidShadow, IsOfTheColourAndTheThicknessOfEachFluid)
{
    World world = wavyPool(0.0f);
    for (Particle& p : world.particles) {
        p.position.y() += 2.0f;
        p.position.z() += 2.0f * std::tan(SLANT);
        p.material = p.position.x() < 0.0f ? 0 : 1;
    }
    world.materials[0].color = {0.2f, 1.0f, 1.0f};
    world.materials[1].color = {1.0f, 1.0f, 0.4f};
    RenderSettings settings = sunlitLook();
    settings.camera.position = {0.0f, 1.0f, 6.0f};
    const auto picture = [&](float absorption) {
        for (Material& material : world.materials) material.look = {DrawnAs::Surface, absorption, 0.0f};
        return drawn(world, settings);
    };
    const Image clear = picture(0.0f), tinted = picture(1.0f);
    const double way = 11 * SPACING / std::cos(SLANT);
    for (const auto& [column, red, blue] : {std::tuple{SIZE / 4, 0.2, 1.0}, std::tuple{3 * SIZE / 4, 1.0, 0.4}}) {
        const auto left = [&, column = column](int channel) {
            const double lit = pixelAt(tinted, column, SIZE / 2)[channel],
                         all = pixelAt(clear, column, SIZE / 2)[channel];
            return std::pow(lit / all, 2.2);
        };
        EXPECT_NEAR(left(0), std::pow(red, way), 0.06) << column;
        EXPECT_NEAR(left(2), std::pow(blue, way), 0.06) << column;
    }
}

}  // namespace
}  // namespace knuckle::test
