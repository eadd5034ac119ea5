#include <cmath>

#include "render/color_word.h"
#include "render/spheres/palette.h"
#include "tests/render/golden.h"
#include "tests/render/render_fixture.h"

namespace knuckle::test {
namespace {

/// A body of 3 x 3 x 3 particles about its rest centre.
const Vector3f LOWER{0, 0.5f, 0}, UPPER{0, 1.5f, 0};

SkinVertex corner(const Vector3f& position, const Vector3f& normal, const Eigen::Vector2f& uv)
{
    SkinVertex vertex;
    vertex.position = position;
    vertex.normal = normal;
    vertex.uv = uv;
    return vertex;
}

/// One square of side 2 `half` that faces +z.
SkinMesh squareMesh(const Vector3f& centre, float half)
{
    SkinMesh mesh;
    for (const auto& [x, y] : {std::pair{-1.0f, -1.0f}, {1.0f, -1.0f}, {1.0f, 1.0f}, {-1.0f, 1.0f}})
        mesh.vertices.push_back(
            corner(centre + half * Vector3f(x, y, 0), Vector3f::UnitZ(), {0.5f + 0.5f * x, 0.5f - 0.5f * y}));
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    mesh.materials.resize(1);
    return mesh;
}

/// Two bodies one above the other, one object with a skin.
struct SkinnedPair {
    SkinnedPair() : still(0.05f)
    {
        for (const Vector3f& centre : {LOWER, UPPER}) still.addBody(cubeLattice(3, 0.1f), centre);
        still.world.bodies[0].restCentre = LOWER;
        still.world.bodies[1].restCentre = UPPER;
        still.world.objects = {{"pair", 0, 2}};
    }
    void wear(const SkinMesh& mesh, SkinUse use = SkinUse::Hide)
    {
        still.world.skins = {{std::make_shared<SkinMesh>(mesh), {0}, use}};
    }
    StillWorld still;
};

/// Looks along -z: 100 pixels a metre at z = 0, the middle of the picture at (0, 1).
RenderSettings front()
{
    RenderSettings settings = lookFrom({0, 1, 10}, {0, 1, 0}, 200, 200);
    settings.camera.fieldOfView = 2.0f * std::atan(0.1f) * 180.0f / 3.14159265f;
    return settings;
}

bool isRed(const Eigen::Vector3i& pixel)
{
    return pixel.x() > pixel.y() + 60;
}

/// Middle and half width of the red pixels.
struct Blob {
    double x = 0, y = 0;
    int count = 0;
};
Blob redOf(const Image& image)
{
    Blob blob;
    for (uint32_t y = 0; y < image.height; ++y)
        for (uint32_t x = 0; x < image.width; ++x)
            if (isRed(pixelAt(image, x, y))) {
                blob.x += x + 0.5;
                blob.y += y + 0.5;
                ++blob.count;
            }
    blob.x /= std::max(blob.count, 1);
    blob.y /= std::max(blob.count, 1);
    return blob;
}

SkinMesh redSquare(const Vector3f& centre, float half)
{
    SkinMesh mesh = squareMesh(centre, half);
    mesh.materials[0].color = {0.8f, 0.02f, 0.02f};
    return mesh;
}

TEST(Skin, FollowsItsBodyExactly)
{
    SkinnedPair pair;
    SkinMesh mesh = redSquare({0.4f, 1.5f, 0}, 0.1f);
    for (SkinVertex& vertex : mesh.vertices) vertex.bodies[0] = 1;
    pair.wear(mesh);
    Body& upper = pair.still.world.bodies[1];
    upper.position = {-0.3f, 0.8f, 0};
    upper.rotation = Quaternionf(Eigen::AngleAxisf(1.57079633f, Vector3f::UnitZ()));
    // The arm (0.4, 0, 0) from the centre at rest has become (0, 0.4, 0): at (-0.3, 1.2) m, 100 pixels a metre.
    // Lighting and painting by single pixels may be off by one on each side.
    const Blob blob = redOf(drawn(pair.still.world, front()));
    EXPECT_NEAR(blob.x, 100 - 30, 0.5);
    EXPECT_NEAR(blob.y, 100 - 20, 0.5);
    EXPECT_NEAR(blob.count, 20 * 20, 40);
}

TEST(Skin, LiesBetweenTwoBodiesAsItsWeightsSay)
{
    SkinnedPair pair;
    SkinMesh mesh = redSquare({0, 1, 0}, 0.1f);
    for (SkinVertex& vertex : mesh.vertices) {
        vertex.bodies = {0, 1, 0, 0};
        vertex.weights = {0.25f, 0.75f, 0, 0};
    }
    pair.wear(mesh);
    pair.still.world.bodies[1].position = UPPER + Vector3f(0.8f, 0, 0);
    const Blob blob = redOf(drawn(pair.still.world, front()));
    EXPECT_NEAR(blob.x, 100 + 0.75 * 80, 0.5);
    EXPECT_NEAR(blob.y, 100, 0.5);
}

TEST(Skin, HidesItsParticlesOrNot)
{
    SkinnedPair pair;
    pair.wear(squareMesh({0.7f, 1, 0}, 0.1f), SkinUse::Cover);
    RenderSettings settings = front();
    const Eigen::Vector3i seen = pixelAt(drawn(pair.still.world, settings), 100, 50);
    pair.wear(squareMesh({0.7f, 1, 0}, 0.1f), SkinUse::Hide);
    const Eigen::Vector3i hidden = pixelAt(drawn(pair.still.world, settings), 100, 50);
    EXPECT_GT((seen - hidden).cwiseAbs().maxCoeff(), 30);
    pair.still.world.skins.clear();
    EXPECT_EQ(pixelAt(drawn(pair.still.world, settings), 100, 50), seen);
}

TEST(Skin, IsSeenFromBehindWhereItIsTwoSided)
{
    SkinnedPair pair;
    RenderSettings settings = front();
    settings.camera.position.z() = -10;
    SkinMesh mesh = redSquare({0, 1, 0}, 0.2f);
    for (const bool twoSided : {true, false}) {
        mesh.materials[0].twoSided = twoSided;
        pair.wear(mesh);
        EXPECT_EQ(redOf(drawn(pair.still.world, settings)).count > 0, twoSided);
        EXPECT_GT(redOf(drawn(pair.still.world, front())).count, 0);
    }
}

TEST(Skin, IsNotThereWhereNoAlphaReachesItsCutoff)
{
    SkinnedPair pair;
    SkinMesh mesh = redSquare({0, 1, 0}, 0.2f);
    for (const float cutoff : {0.5f, 2.0f}) {
        mesh.materials[0].alphaCutoff = cutoff;
        pair.wear(mesh);
        EXPECT_EQ(redOf(drawn(pair.still.world, front())).count > 0, cutoff < 1.0f) << "without a picture alpha is 1";
    }
}

TEST(Skin, APictureIsTheRightWayUpAndRepeats)
{
    SkinnedPair pair;
    SkinMesh mesh = squareMesh({0, 1, 0}, 0.4f);
    mesh.materials[0] = {"paint", {1, 1, 1}, 0, true, 0.5f};
    // Red, green above; blue, and nothing at all.
    mesh.textures = {{2, 2, {230, 0, 0, 255, 0, 230, 0, 255, 0, 0, 230, 255, 255, 255, 255, 0}}};
    for (SkinVertex& vertex : mesh.vertices) vertex.uv += Eigen::Vector2f(3, -7);
    pair.wear(mesh);
    const Image image = drawn(pair.still.world, front());
    const auto strongest = [&](uint32_t x, uint32_t y) {
        const Eigen::Vector3i pixel = pixelAt(image, x, y);
        int index = 0;
        return pixel.maxCoeff(&index) - pixel.minCoeff() > 60 ? index : -1;
    };
    EXPECT_EQ(strongest(80, 80), 0);
    EXPECT_EQ(strongest(120, 80), 1);
    EXPECT_EQ(strongest(80, 120), 2);
    EXPECT_EQ(strongest(120, 120), -1);
}

/// A picture with a red left and a blue right half; the square shows the place 1 ... 2.
TEST(Skin, APicturesEdgesRepeatMirrorOrStay)
{
    SkinnedPair pair;
    SkinMesh mesh = squareMesh({0, 1, 0}, 0.4f);
    mesh.materials[0] = {"paint", {1, 1, 1}, 0};
    mesh.textures = {{2, 1, {230, 0, 0, 255, 0, 0, 230, 255}}};
    for (SkinVertex& vertex : mesh.vertices) vertex.uv += Eigen::Vector2f(1, 0);
    const auto redAt = [&](uint32_t x, TextureWrap wrap) {
        mesh.materials[0].wrap = {wrap, TextureWrap::Repeat};
        pair.wear(mesh);
        const Eigen::Vector3i pixel = pixelAt(drawn(pair.still.world, front()), x, 100);
        return pixel.x() > pixel.z();
    };
    const uint32_t left = 80, right = 120;
    EXPECT_TRUE(redAt(left, TextureWrap::Repeat) && !redAt(right, TextureWrap::Repeat));
    EXPECT_TRUE(!redAt(left, TextureWrap::Mirror) && redAt(right, TextureWrap::Mirror));
    EXPECT_TRUE(!redAt(left, TextureWrap::Clamp) && !redAt(right, TextureWrap::Clamp));
}

/// The lower body's particles are nearest to a red or a green corner; the upper one has a picture, blue above and white
/// below. The vertex nearest to the upper one's lowest particles is a corner of the lower body.
TEST(Skin, PaintsParticlesAsTheNearestVertexOfTheirBody)
{
    SkinnedPair pair;
    SkinMesh mesh = squareMesh(LOWER, 0.15f);
    for (SkinVertex& vertex : mesh.vertices)
        vertex.color = vertex.position.x() < 0 ? Vector3f(0.8f, 0, 0) : Vector3f(0, 0.8f, 0);
    for (SkinVertex vertex : squareMesh(UPPER, 0.15f).vertices) {
        vertex.bodies[0] = 1;
        vertex.material = 1;
        mesh.vertices.push_back(vertex);
    }
    mesh.vertices.push_back(corner({0, 1.3f, 0}, Vector3f::UnitZ(), {0, 0}));
    mesh.materials.resize(2);
    for (SkinMaterial& material : mesh.materials) material.color = {1, 1, 1};
    mesh.materials[1].texture = 0;
    mesh.textures = {{1, 2, {0, 0, 255, 255, 255, 255, 255, 255}}};
    for (SkinVertex& vertex : mesh.vertices) vertex.uv.y() = std::clamp(vertex.uv.y(), 0.25f, 0.75f);
    pair.wear(mesh, SkinUse::Paint);
    const World& world = pair.still.world;
    const std::vector<uint32_t> words = particleColors(world, {});
    for (const Link& link : world.links) {
        const Vector3f& away = link.restOffset;
        if (std::abs(link.body == 0 ? away.x() : away.y()) < 0.05f) continue;  // as near to both
        const Vector3f lower(away.x() < 0 ? 0.8f : 0, away.x() > 0 ? 0.8f : 0, 0);
        const Vector3f upper = away.y() > 0 ? Vector3f(0, 0, 1) : Vector3f(1, 1, 1);
        EXPECT_LT((unpackColor(words[link.particle]) - (link.body == 0 ? lower : upper)).norm(), 0.01f)
            << link.body << " at " << away.transpose();
    }
    RenderSettings byParticle;
    byParticle.colorBy = ColorBy::Particle;
    EXPECT_EQ(particleColors(world, byParticle)[0], packColor(paletteColor(0)));
    EXPECT_EQ(redOf(drawn(world, front())).count > 0, true) << "particles are drawn";
}

/// A tube about both bodies, striped, whose weights go over from one to the other around y = 1.
SkinMesh tube()
{
    constexpr uint32_t SIDES = 24, RINGS = 20;
    SkinMesh mesh;
    for (uint32_t r = 0; r <= RINGS; ++r)
        for (uint32_t s = 0; s <= SIDES; ++s) {
            const float u = float(s) / float(SIDES), y = 0.1f + 1.8f * float(r) / float(RINGS);
            const Vector3f out(std::cos(6.2831853f * u), 0, -std::sin(6.2831853f * u));
            SkinVertex vertex = corner(0.25f * out + Vector3f(0, y, 0), out, {2 * u, 4 * y});
            vertex.bodies = {0, 1, 0, 0};
            const float upper = std::clamp(0.5f + 1.5f * (y - 1.0f), 0.0f, 1.0f);
            vertex.weights = {1 - upper, upper, 0, 0};
            mesh.vertices.push_back(vertex);
        }
    for (uint32_t r = 0; r < RINGS; ++r)
        for (uint32_t s = 0; s < SIDES; ++s) {
            const uint32_t a = r * (SIDES + 1) + s, b = a + SIDES + 1;
            mesh.triangles.push_back({a, a + 1, b + 1});
            mesh.triangles.push_back({a, b + 1, b});
        }
    mesh.materials = {{"stripes", {1, 1, 1}, 0}};
    mesh.textures = {{2, 2, {200, 60, 40, 255, 230, 200, 150, 255, 230, 200, 150, 255, 200, 60, 40, 255}}};
    return mesh;
}

RenderSettings aside()
{
    RenderSettings settings = lookFrom({2.0f, 1.6f, 3.2f}, {0.2f, 0.9f, 0}, 192, 144);
    settings.skinError = 0.0f;  // the triangles of coarse levels depend on the library's version
    return settings;
}

TEST(Golden, ASkinAtRest)
{
    SkinnedPair pair;
    pair.still.addGround();
    pair.wear(tube());
    expectGolden("skin_rest", drawn(pair.still.world, aside()));
}

TEST(Golden, ASkinBentAtItsJoint)
{
    SkinnedPair pair;
    pair.still.addGround();
    pair.wear(tube());
    Body& upper = pair.still.world.bodies[1];
    upper.rotation = Quaternionf(Eigen::AngleAxisf(-1.2f, Vector3f::UnitZ()));
    upper.position = Vector3f(0, 1, 0) + upper.rotation * Vector3f(0, 0.5f, 0);
    expectGolden("skin_bent", drawn(pair.still.world, aside()));
}

}  // namespace
}  // namespace knuckle::test
