#include "render/skins/skin_lods.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <random>

#include "render/skins/skin_buffers.h"
#include "shared/frame_types.h"
#include "sim/gpu/kernel.h"
#include "tests/render/render_fixture.h"

namespace knuckle::test {
namespace {

/// Adds the triangles between rings of vertices, one after another.
void connectRings(uint32_t rings, uint32_t sides, SkinMesh& mesh)
{
    for (uint32_t r = 0; r < rings; ++r)
        for (uint32_t s = 0; s < sides; ++s) {
            const uint32_t a = r * sides + s, b = r * sides + (s + 1) % sides;
            mesh.triangles.push_back({a, b, b + sides});
            mesh.triangles.push_back({a, b + sides, a + sides});
        }
}

/// A ball of radius 1 in `rings` rings of twice as many vertices, of one body.
SkinMesh ball(uint32_t rings)
{
    SkinMesh mesh;
    const uint32_t sides = 2 * rings;
    for (uint32_t r = 0; r <= rings; ++r)
        for (uint32_t s = 0; s < sides; ++s) {
            const double up = M_PI * r / rings, around = 2 * M_PI * s / sides;
            SkinVertex vertex;
            vertex.position = Eigen::Vector3d(std::sin(up) * std::cos(around), std::cos(up),
                                              std::sin(up) * std::sin(around))
                                  .cast<float>();
            vertex.normal = vertex.position;
            mesh.vertices.push_back(vertex);
        }
    connectRings(rings, sides, mesh);
    mesh.materials.resize(1);
    return mesh;
}

Vector3f placeOf(const SkinMesh& mesh, const SkinLods& lods, uint32_t index)
{
    return mesh.vertices[lods.vertices[lods.indices[index]]].position;
}

TEST(SkinLods, TheFirstIsTheMeshItself)
{
    const SkinMesh mesh = ball(20);
    const SkinLods lods = makeSkinLods(mesh);
    EXPECT_EQ(lods.levels[0].error, 0.0f);
    EXPECT_EQ(lods.levels[0].indexCount, 3 * mesh.triangles.size());
    EXPECT_EQ(lods.levels[0].vertexCount, mesh.vertices.size());
    // Each triangle is there, from whichever corner it begins: their centres add up to the same.
    Vector3f wanted(0, 0, 0), found(0, 0, 0);
    for (const auto& triangle : mesh.triangles)
        for (const uint32_t corner : triangle)
            wanted += mesh.vertices[corner].position.cwiseAbs2() * float(triangle[0] + triangle[1] + triangle[2]);
    for (uint32_t i = 0; i < lods.levels[0].indexCount; i += 3)
        for (uint32_t k = 0; k < 3; ++k)
            found += placeOf(mesh, lods, i + k).cwiseAbs2() *
                     float(lods.vertices[lods.indices[i]] + lods.vertices[lods.indices[i + 1]] +
                           lods.vertices[lods.indices[i + 2]]);
    EXPECT_NEAR((found - wanted).norm() / wanted.norm(), 0.0f, 1e-4f);
}

TEST(SkinLods, CoarserOnesAreSmallerAndUseTheFirstVertices)
{
    const SkinLods lods = makeSkinLods(ball(40));
    ASSERT_GT(lods.levels.size(), 5u);
    for (size_t i = 1; i < lods.levels.size(); ++i) {
        const SkinLod &fine = lods.levels[i - 1], &coarse = lods.levels[i];
        EXPECT_LE(coarse.indexCount, 0.8 * fine.indexCount) << i;
        EXPECT_LT(coarse.vertexCount, fine.vertexCount) << i;
        EXPECT_GE(coarse.error, fine.error) << i;
        for (uint32_t k = 0; k < coarse.indexCount; ++k)
            ASSERT_LT(lods.indices[coarse.firstIndex + k], coarse.vertexCount) << i;
    }
}

/// All vertices of a level lie on the ball, so its surface is furthest off in the middle of triangles. The error of
/// quadrics is a mean over planes: the largest distance may be twice that.
TEST(SkinLods, TheirSurfaceIsAsFarOffAsTheySay)
{
    const SkinMesh mesh = ball(40);
    const SkinLods lods = makeSkinLods(mesh);
    for (const SkinLod& lod : lods.levels) {
        float worst = 0.0f;
        for (uint32_t i = 0; i < lod.indexCount; i += 3) {
            Vector3f middle(0, 0, 0);
            for (uint32_t k = 0; k < 3; ++k) middle += placeOf(mesh, lods, lod.firstIndex + i + k) / 3.0f;
            worst = std::max(worst, 1.0f - middle.norm());
        }
        // The mesh itself is off the ball by half the square of half an edge.
        EXPECT_LE(worst, 2.0f * lod.error + 0.5f * std::pow(float(M_PI) / 40, 2.0f)) << lod.indexCount / 3;
    }
}

/// A straight tube along y of two bodies that blend between -0.5 and 0.5, or change at once at 0.
SkinMesh tube(bool smooth)
{
    constexpr uint32_t SIDES = 24, RINGS = 100;
    SkinMesh mesh;
    for (uint32_t r = 0; r <= RINGS; ++r)
        for (uint32_t s = 0; s < SIDES; ++s) {
            const float angle = 6.2831853f * float(s) / SIDES, y = -2.0f + 4.0f * float(r) / RINGS;
            SkinVertex vertex;
            vertex.position = {0.25f * std::cos(angle), y, 0.25f * std::sin(angle)};
            const float upper = smooth ? std::clamp(0.5f + y, 0.0f, 1.0f) : y > 0.0f ? 1.0f : 0.0f;
            vertex.bodies = {0, 1, 0, 0};
            vertex.weights = {1.0f - upper, upper, 0, 0};
            mesh.vertices.push_back(vertex);
        }
    connectRings(RINGS, SIDES, mesh);
    mesh.materials.resize(1);
    return mesh;
}

/// A tube that is straight at rest needs only the first and the last ring; when bent it needs more.
TEST(SkinLods, RingsStayWhereASkinBends)
{
    for (const bool smooth : {true, false}) {
        const SkinMesh mesh = tube(smooth);
        const SkinLods lods = makeSkinLods(mesh);
        const auto level = std::ranges::find_if(lods.levels, [](const SkinLod& lod) { return lod.error > 0.01f; });
        ASSERT_NE(level, lods.levels.begin());
        const SkinLod& lod = *(level - 1);
        uint32_t bending = 0, straight = 0;
        for (uint32_t i = 0; i < lod.vertexCount; ++i) {
            const float y = std::abs(mesh.vertices[lods.vertices[i]].position.y());
            if (y < 0.55f) ++bending;
            else if (y > 0.6f && y < 1.9f) ++straight;
        }
        EXPECT_GE(bending, 2 * 12u) << smooth;
        EXPECT_LT(straight, bending) << smooth;
    }
}

/// Balls at different distances in a picture of 100 pixels whose camera looks along -z, and the results of
/// skin_lod.comp and skin_pose.comp for them.
class SkinKernels : public ::testing::Test {
protected:
    void put(const std::vector<Vector3f>& places)
    {
        for (const Vector3f& place : places) still.addBody(cubeLattice(2, 0.1f), place);
        still.world.objects.clear();
        std::vector<uint32_t> wearers;
        for (uint32_t i = 0; i < places.size(); ++i) {
            still.world.objects.push_back({"ball", i, 1});
            wearers.push_back(i);
        }
        still.world.skins = {{mesh, wearers, SkinUse::Hide}};
    }

    void pose(float skinError = RenderSettings{}.skinError)
    {
        frameInput.keyColor.w = skinError;
        frameInput.width = frameInput.height = 100;
        frameInput.tanHalfFov = 0.5f;
        frameInput.resolveFactor = 1;
        frameInput.shadowSize = 100.0f;
        frameView.cameraRight = {1, 0, 0, 0};
        frameView.cameraUp = {0, 1, 0, 0};
        frameView.cameraBack = {0, 0, 1, 0};
        frameView.lightCentre = {0, 0, 0, 20.0f};
        frame.upload({&frameInput, 1});
        view.upload({&frameView, 1});
        skins = SkinBuffers(sharedGpu(), still.world);
        std::vector<gpu::vec4> centreValues, rotationValues;
        for (const Body& body : still.world.bodies) {
            const Vector3f& p = body.position;
            const Eigen::Vector4f q = body.rotation.coeffs();
            centreValues.push_back({p.x(), p.y(), p.z(), 0});
            rotationValues.push_back({q.x(), q.y(), q.z(), q.w()});
        }
        centres = {"bodyCentres", std::span<const gpu::vec4>(centreValues)};
        rotations = {"bodyRotations", std::span<const gpu::vec4>(rotationValues)};
        table.add(Lifetime::Scratch, frame, view, centres, rotations);
        skins.addTo(table);
        KernelTimer timer;
        Kernel(sharedGpu(), table, "render/skins/skin_lod.comp").dispatch(timer, 1);
        Kernel(sharedGpu(), table, "render/skins/skin_pose.comp").dispatch(timer, skins.groupCount);
    }

    /// Indices of the coarsest level whose error is at most this.
    uint32_t indicesWithin(float error) const
    {
        uint32_t count = 0;
        for (const SkinLod& lod : lods.levels)
            if (lod.error <= error) count = lod.indexCount;
        return count;
    }

    std::shared_ptr<const SkinMesh> mesh = std::make_shared<const SkinMesh>(ball(20));
    SkinLods lods = makeSkinLods(*mesh);
    StillWorld still{0.05f};
    gpu::FrameInput frameInput{};
    gpu::FrameView frameView{};
    Gpu& gpu = sharedGpu();
    Buffer<gpu::FrameInput> frame{"frame", 1};
    Buffer<gpu::FrameView> view{"view", 1};
    Buffer<gpu::vec4> centres, rotations;
    SkinBuffers skins;
    BufferTable table;
};

TEST_F(SkinKernels, EachIsDrawnAsCoarselyAsAPixelAllows)
{
    const std::vector<Vector3f> places = {{0, 0, -1.5f}, {0, 0, -5}, {2, -3, -16},
                                          {0, 0, -301},  {0, 0, 5},  {20, 0, -11}};
    put(places);
    pose();
    const std::vector<gpu::DrawElementsArguments> draws = skins.draws.download();
    const std::vector<uint32_t> counts = skins.placeCounts.download();
    const auto count = uint32_t(places.size());
    for (uint32_t i = 0; i < count; ++i) {
        // A pixel is a hundredth of the view's width at the nearest point of the ball, which is a metre before its
        // centre.
        const float depth = -places[i].z() - 1.0f;
        const bool inSight = i < 4;
        EXPECT_EQ(draws[i].count, inSight ? indicesWithin(RenderSettings{}.skinError * depth / 100) : 0u) << i;
        // 40 m over 100 texels.
        EXPECT_EQ(draws[count + i].count, indicesWithin(0.4f * SKIN_TEXELS_A_PIXEL * RenderSettings{}.skinError)) << i;
        for (const uint32_t k : {i, count + i}) {
            EXPECT_EQ(draws[k].instanceCount, 1u);
            EXPECT_EQ(draws[k].baseVertex % SKIN_GROUP_SIZE, 0u);
            if (draws[k].count == 0) continue;
            const auto lod = std::ranges::find(lods.levels, draws[k].firstIndex, &SkinLod::firstIndex);
            ASSERT_NE(lod, lods.levels.end());
            EXPECT_EQ(lod->indexCount, draws[k].count);
            EXPECT_GE(counts[i], lod->vertexCount);
        }
    }
    EXPECT_GT(draws[0].count, draws[1].count);
    EXPECT_GT(draws[1].count, draws[2].count);
    EXPECT_GT(draws[2].count, draws[3].count);
}

TEST_F(SkinKernels, AllTrianglesAreDrawnWhereNoneMayBeOff)
{
    put({{0, 0, -16}, {0, 0, -301}});
    pose(0.0f);
    for (const gpu::DrawElementsArguments& draw : skins.draws.download())
        EXPECT_EQ(draw.count, lods.levels.front().indexCount);
}

TEST_F(SkinKernels, VerticesAreWhereTheirBodiesHaveThem)
{
    SkinMesh blended = *mesh;
    std::mt19937 random(7);
    std::uniform_real_distribution<float> part(0.0f, 1.0f);
    for (SkinVertex& vertex : blended.vertices) {
        vertex.bodies = {2, 0, 1, 0};
        const float first = part(random), second = part(random) * (1.0f - first);
        vertex.weights = {first, second, 1.0f - first - second, 0.0f};
        vertex.normal.normalize();
    }
    mesh = std::make_shared<const SkinMesh>(blended);
    lods = makeSkinLods(*mesh);
    for (const float x : {0.0f, 0.5f, -0.7f}) still.addBody(cubeLattice(2, 0.1f), {x, 0.2f, -1.5f});
    for (uint32_t b = 0; b < 3; ++b) {
        Body& body = still.world.bodies[b];
        body.restCentre = {0.1f * float(b), 0.3f, 0};
        body.rotation = Quaternionf(Eigen::AngleAxisf(0.4f + float(b), Vector3f(1, 2, 3).normalized()));
    }
    still.world.objects = {{"figure", 0, 3}};
    still.world.skins = {{mesh, {0}, SkinUse::Hide}};
    pose();
    const std::vector<gpu::uvec4> found = skins.places.download();
    ASSERT_EQ(skins.placeCounts.download()[0], mesh->vertices.size());
    for (uint32_t i = 0; i < mesh->vertices.size(); ++i) {
        const SkinVertex& vertex = mesh->vertices[lods.vertices[i]];
        Eigen::Vector3d wanted(0, 0, 0);
        for (int k = 0; k < 3; ++k) {
            const Body& body = still.world.bodies[vertex.bodies[k]];
            const Vector3f place = body.position + body.rotation * (vertex.position - body.restCentre);
            wanted += double(vertex.weights[k]) * place.cast<double>();
        }
        const Vector3f place(std::bit_cast<float>(found[i].x), std::bit_cast<float>(found[i].y),
                             std::bit_cast<float>(found[i].z));
        // Weights have 16 bits, bodies are up to 4 m apart there.
        ASSERT_NEAR((place.cast<double>() - wanted).norm(), 0.0, 3 * 4.0 * 0.5 / 65535 + 1e-6) << i;
    }
}

}  // namespace
}  // namespace knuckle::test
