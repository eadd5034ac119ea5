#include <cmath>
#include <numbers>

#include "render/sky/clear_sky.h"
#include "tests/render/render_fixture.h"

namespace knuckle::test {
namespace {

constexpr double DEGREE_OF_ARC = std::numbers::pi / 180.0;

Vector3f sunAt(double elevation)
{
    return {0.0f, static_cast<float>(std::sin(elevation)), static_cast<float>(std::cos(elevation))};
}

TEST(ClearSky, ZenithIsThatOfThePaper)
{
    // Appendix A.2 of Preetham, Shirley and Smits 1999, written out as it stands there.
    for (const double elevation : {5.0, 30.0, 70.0})
        for (const double T : {2.5, 6.0}) {
            const double s = (90.0 - elevation) * DEGREE_OF_ARC, s2 = s * s, s3 = s2 * s, T2 = T * T;
            const double chi = (4.0 / 9.0 - T / 120.0) * (std::numbers::pi - 2.0 * s);
            const double Y = (4.0453 * T - 4.9710) * std::tan(chi) - 0.2155 * T + 2.4192;
            const double x = T2 * (0.00166 * s3 - 0.00375 * s2 + 0.00209 * s) +
                             T * (-0.02903 * s3 + 0.06377 * s2 - 0.03202 * s + 0.00394) +
                             (0.11693 * s3 - 0.21196 * s2 + 0.06052 * s + 0.25886);
            const double y = T2 * (0.00275 * s3 - 0.00610 * s2 + 0.00317 * s) +
                             T * (-0.04214 * s3 + 0.08970 * s2 - 0.04153 * s + 0.00516) +
                             (0.15346 * s3 - 0.26756 * s2 + 0.06670 * s + 0.26688);
            const Eigen::Vector3d zenith = ClearSky(sunAt(elevation * DEGREE_OF_ARC), T).zenith();
            // The sun's direction is in floats: its angle is right within 1e-6, the values within 1e-5 of theirs.
            EXPECT_NEAR(zenith.x(), x, 1e-5) << elevation << ", " << T;
            EXPECT_NEAR(zenith.y(), y, 1e-5) << elevation << ", " << T;
            EXPECT_NEAR(zenith.z(), Y, 1e-5 * std::abs(Y) + 1e-5) << elevation << ", " << T;
            const Eigen::Vector3d up = ClearSky(sunAt(elevation * DEGREE_OF_ARC), T).towards({0, 1, 0});
            EXPECT_NEAR((up - zenith).norm(), 0.0, 1e-9) << "the distribution is 1 straight up";
        }
}

TEST(ClearSky, IsBrightestAroundTheSunAndRedsWhenItIsLow)
{
    const Vector3f sun = sunAt(30.0 * DEGREE_OF_ARC);
    const SkyMap map = ClearSky(sun, 3.0).map();
    size_t brightest = 0;
    for (size_t i = 0; i < map.radiance.size(); ++i)
        if (map.radiance[i].sum() > map.radiance[brightest].sum()) brightest = i;
    const auto width = size_t{map.width};
    const Vector3f way = map.direction(static_cast<uint32_t>(brightest % width),
                                       static_cast<uint32_t>(brightest / width));
    // Texels are 1.4 degrees wide.
    EXPECT_LT(std::acos(way.dot(sun)), 2.0 * DEGREE_OF_ARC);
    const Vector3f high = ClearSky(sunAt(60.0 * DEGREE_OF_ARC), 3.0).sunColor();
    const Vector3f low = ClearSky(sunAt(4.0 * DEGREE_OF_ARC), 3.0).sunColor();
    EXPECT_GT(high.z(), 0.7f);
    EXPECT_LT(low.z(), 0.35f);
    EXPECT_FLOAT_EQ(low.x(), 1.0f);
    // As bright on the mean as the gradient.
    EXPECT_NEAR(map.meanOf(true).dot(Vector3f(0.2126f, 0.7152f, 0.0722f)), 0.668f, 1e-3f);
}

/// Red above, blue below, and a green spot towards -z.
SkyMap coloredSky()
{
    SkyMap map{64, 32, {}};
    for (uint32_t row = 0; row < map.height; ++row)
        for (uint32_t column = 0; column < map.width; ++column)
            map.radiance.push_back(map.direction(column, row).z() < -0.97f ? Vector3f(0, 1, 0)
                                   : row < map.height / 2                  ? Vector3f(1, 0, 0)
                                                                           : Vector3f(0, 0, 1));
    return map;
}

TEST(SkyMap, MeansAreWeightedByCosines)
{
    const SkyMap map{8, 4, std::vector<Vector3f>(32, Vector3f(0.25f, 0.5f, 1.0f))};
    EXPECT_LT((map.meanOf(true) - Vector3f(0.25f, 0.5f, 1.0f)).norm(), 1e-6f);
    EXPECT_LT((blurred(map, 0.5f, 8).at(3, 1) - Vector3f(0.25f, 0.5f, 1.0f)).norm(), 1e-5f);
    EXPECT_LT((halved(map).at(1, 1) - Vector3f(0.25f, 0.5f, 1.0f)).norm(), 1e-6f);
    float sphere = 0.0f;
    for (uint32_t row = 0; row < map.height; ++row) sphere += 8.0f * map.solidAngle(row);
    EXPECT_NEAR(sphere, 4.0f * std::numbers::pi_v<float>, 1e-4f);
    const SkyMap colored = coloredSky();
    // The spot of 14 degrees at the horizon takes little of either half.
    EXPECT_GT(colored.meanOf(true).x(), 0.97f);
    EXPECT_GT(colored.meanOf(false).z(), 0.97f);
}

TEST(SkyPicture, StandsWhereItsDirectionsAre)
{
    StillWorld still(0.05f);
    RenderSettings settings = lookFrom({0, 0, 0}, {0, 0, -1}, 64, 64);
    settings.camera.fieldOfView = 60.0f;
    settings.toneMap = ToneMap::Linear;
    settings.light.sky = std::make_shared<const SkyMap>(coloredSky());
    const Image ahead = drawn(still.world, settings);
    EXPECT_EQ(pixelAt(ahead, 32, 32), Eigen::Vector3i(0, 255, 0));
    EXPECT_EQ(pixelAt(ahead, 32, 4), Eigen::Vector3i(255, 0, 0));
    EXPECT_EQ(pixelAt(ahead, 32, 60), Eigen::Vector3i(0, 0, 255));
    settings.camera.target = {1, 0, 0};
    EXPECT_EQ(pixelAt(drawn(still.world, settings), 32, 4), Eigen::Vector3i(255, 0, 0));
    EXPECT_EQ(pixelAt(drawn(still.world, settings), 32, 60), Eigen::Vector3i(0, 0, 255));
}

TEST(LightSources, FadeWithTheSquareOfTheDistance)
{
    // Straight under a light a white matt box sends back 0.4 of it.
    const auto lightUnder = [](float height) {
        StillWorld still(0.05f);
        Collider& box = still.addCollider(ColliderShape::Box, {0, -0.5f, 0});
        box.halfExtents = {5, 0.5f, 5};
        box.color = {0.5f, 0.5f, 0.5f};
        RenderSettings settings = lookFrom({3, 3, 0}, {0, 0, 0}, 65, 65);
        settings.toneMap = ToneMap::Linear;
        settings.light.intensity = 0.0f;
        settings.light.skyColor = settings.light.groundColor = {0, 0, 0};
        settings.lights = {{.isPoint = true, .place = {0, height, 0}, .color = {1, 1, 1}, .intensity = 4.0f}};
        const float shown = static_cast<float>(pixelAt(drawn(still.world, settings), 32, 32).y()) / 255.0f;
        return std::pow((shown + 0.055f) / 1.055f, 2.4f);
    };
    // 0.5 x 4 x 0.4, over the square of the height, and of the sheen 4 x 0.05 times the cosine to the half vector, 22.5
    // degrees away, to the 32nd power. Steps of 1/255 of what is displayed and of the colour's root are 0.007 and
    // 0.006.
    const float expected = 0.8f + 0.2f * std::pow(std::cos(0.3927f), 32.0f);
    EXPECT_NEAR(lightUnder(1.0f), expected, 0.008f);
    EXPECT_NEAR(lightUnder(2.0f), 0.25f * expected, 0.004f);
}

}  // namespace
}  // namespace knuckle::test
