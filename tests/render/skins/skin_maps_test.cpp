#include <cmath>

#include "tests/render/render_fixture.h"

namespace knuckle::test {
namespace {

constexpr uint32_t SIZE = 64;

/// One pixel of a picture.
TexturePicture plain(uint8_t red, uint8_t green, uint8_t blue)
{
    return {1, 1, {red, green, blue, 255}};
}

/// A square of 2 m that faces +z, of one material.
World squareOf(const SkinMaterial& material, const std::vector<TexturePicture>& textures, Finish finish)
{
    StillWorld still(0.05f);
    still.addBody(cubeLattice(3, 0.1f), {0, 0, 0});
    still.world.objects = {{"square", 0, 1}};
    still.world.materials[0].finish.word = finish;
    auto mesh = std::make_shared<SkinMesh>();
    for (const auto& [x, y] : {std::pair{-1.0f, -1.0f}, {1.0f, -1.0f}, {1.0f, 1.0f}, {-1.0f, 1.0f}}) {
        SkinVertex vertex;
        vertex.position = {x, y, 0};
        vertex.normal = {0, 0, 1};
        vertex.uv = {0.5f + 0.5f * x, 0.5f - 0.5f * y};
        mesh->vertices.push_back(vertex);
    }
    mesh->triangles = {{0, 1, 2}, {0, 2, 3}};
    mesh->materials = {material};
    mesh->textures = textures;
    still.world.skins = {{mesh, {0}, SkinUse::Hide}};
    return still.world;
}

RenderSettings litFrom(const Vector3f& direction)
{
    RenderSettings settings = lookFrom({0, 0, 3}, {0, 0, 0}, SIZE, SIZE);
    settings.toneMap = ToneMap::Linear;
    settings.light.direction = direction;
    settings.light.softness = 0.0f;
    settings.light.skyColor = settings.light.groundColor = {0, 0, 0};
    return settings;
}

double lightOf(const World& world, const Vector3f& direction)
{
    const int shown = pixelAt(drawn(world, litFrom(direction)), SIZE / 2 + 5, SIZE / 2 + 9).y();
    return std::pow((shown / 255.0 + 0.055) / 1.055, 2.4);
}

TEST(SkinMaps, NormalsLeanAlongTheirPicture)
{
    SkinMaterial flat, bumped;
    bumped.normals = 0;
    const Vector3f right(0.6f, 0, 0.8f), up(0, 0.6f, 0.8f), ahead(0, 0, 1);
    const double straight = lightOf(squareOf(flat, {}, Finish::Matte), ahead);
    ASSERT_GT(straight, 0.3);
    // Red is along u, to the right; green upwards, against v; 0.6 and 0.8 as 8 bits.
    for (const auto& [lean, picture] : {std::pair{right, plain(204, 128, 230)}, {up, plain(128, 204, 230)}}) {
        const World world = squareOf(bumped, {picture}, Finish::Matte);
        // Lambert's law; what a matte surface mirrors, 0.008 of light at most a few times as bright, is below 3 %.
        for (const Vector3f& way : {right, up, ahead})
            EXPECT_NEAR(lightOf(world, way), straight * lean.dot(way), 0.03 * straight) << lean << way;
    }
    bumped.normalScale = 0.5f;
    const World half = squareOf(bumped, {plain(204, 128, 230)}, Finish::Matte);
    EXPECT_NEAR(lightOf(half, ahead), straight * 0.8 / std::hypot(0.8, 0.3), 0.03 * straight);
}

TEST(SkinMaps, RoughnessesAndMetalsAreThoseOfTheirPicture)
{
    SkinMaterial mapped, plainOne;
    mapped.roughnesses = 0;
    mapped.color = plainOne.color = {0.9f, 0.5f, 0.2f};
    RenderSettings settings = litFrom({0.1f, 0.2f, 1.0f});
    settings.light.skyColor = {1, 1, 1};
    // Steps of 1/15: 51 of 255 is the third. Blue is metal or not.
    for (const uint8_t metal : {uint8_t{0}, uint8_t{255}}) {
        plainOne.roughness = 0.2f;
        plainOne.metalness = metal / 255.0f;
        const Image asMapped = drawn(squareOf(mapped, {plain(0, 51, metal)}, Finish::Model), settings);
        EXPECT_EQ(asMapped.rgb, drawn(squareOf(plainOne, {}, Finish::Model), settings).rgb) << int(metal);
    }
    // A word of the material's own counts instead.
    EXPECT_EQ(drawn(squareOf(mapped, {plain(0, 51, 255)}, Finish::Wax), settings).rgb,
              drawn(squareOf(plainOne, {}, Finish::Wax), settings).rgb);
}

}  // namespace
}  // namespace knuckle::test
