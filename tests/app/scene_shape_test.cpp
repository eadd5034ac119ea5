#include "sim/world/fingerprint/fingerprint.h"
#include "tests/app/one_object_scene.h"

namespace knuckle::test {
namespace {

const char* const SHAPES = R"("materials": { "default": { "draw": "shape" }, "dots": {} }, )";

TEST(SceneShape, HasTheSizeOfTheObject)
{
    const World ball = worldOf(R"({ "type": "rigid", "shape": "sphere", "radius": 0.3, "draw": "shape" })");
    ASSERT_EQ(ball.bodyShapes.size(), 1u);
    EXPECT_EQ(ball.bodyShapes[0].halfSides, Vector3f(0, 0, 0));
    EXPECT_FLOAT_EQ(ball.bodyShapes[0].radius, 0.3f);
    const World capsule = worldOf(
        R"({ "type": "rigid", "shape": "capsule", "radius": 0.1, "length": 0.6, "draw": "shape" })");
    EXPECT_EQ(capsule.bodyShapes[0].halfSides, Vector3f(0, 0.3f, 0));
    // 10 x 4 x 6 particles of 0.05 m; edges are as round as particles.
    const World box = worldOf(R"({ "type": "rigid", "shape": "box", "size": [0.5, 0.2, 0.3], "draw": "shape" })");
    EXPECT_TRUE(box.bodyShapes[0].halfSides.isApprox(Vector3f(0.225f, 0.075f, 0.125f), 1e-5f));
    EXPECT_FLOAT_EQ(box.bodyShapes[0].radius, 0.025f);
    EXPECT_LT(box.bodyShapes[0].middle.norm(), 1e-6f);
}

TEST(SceneShape, IsDrawnWhereObjectOrMaterialSaysSo)
{
    const std::string box = R"({ "type": "rigid", "shape": "box")";
    EXPECT_TRUE(worldOf(box + "}").bodyShapes.empty());
    EXPECT_EQ(worldOf(box + "}", SHAPES).bodyShapes.size(), 1u);
    EXPECT_EQ(worldOf(box + R"(, "repeat": { "counts": [3, 1, 1] }})", SHAPES).bodyShapes.size(), 3u);
    EXPECT_TRUE(worldOf(box + R"(, "draw": "particles" })", SHAPES).bodyShapes.empty());
    EXPECT_TRUE(worldOf(box + R"(, "material": "dots" })", SHAPES).bodyShapes.empty());
    EXPECT_EQ(worldOf(box + R"(, "material": "dots", "draw": "shape" })", SHAPES).bodyShapes.size(), 1u);
    const std::string mesh = R"({ "type": "rigid", "shape": "mesh", "file": "FILE" })";
    const World skinned = worldOf(mesh, SHAPES);
    EXPECT_TRUE(skinned.bodyShapes.empty());
    EXPECT_EQ(skinned.skins.size(), 1u);
}

TEST(SceneShape, EveryBoxOfAChainHasItsOwn)
{
    const World chain = worldOf(R"({ "type": "joined", "bodies": 3, "size": [3, 2, 4], "lastMaterial": "dots" })",
                                SHAPES);
    ASSERT_EQ(chain.bodyShapes.size(), 2u);
    for (uint32_t b = 0; b < 2; ++b) {
        const BodyShape& shape = chain.bodyShapes[b];
        EXPECT_EQ(shape.body, b);
        EXPECT_TRUE(shape.halfSides.isApprox(Vector3f(0.05f, 0.025f, 0.075f), 1e-5f));
        EXPECT_TRUE(shape.middle.isApprox(Vector3f(0.2f * (float(b) - 1.0f), 0, 0), 1e-5f) || b == 1);
    }
}

TEST(SceneShape, DoesNotChangeWhatMoves)
{
    const std::string box = R"({ "type": "rigid", "shape": "box")";
    EXPECT_EQ(fingerprint(worldOf(box + R"(, "draw": "shape" })")), fingerprint(worldOf(box + "}")));
}

TEST(SceneShape, WhatCannotBeDrawnIsTold)
{
    const std::string box = R"({ "type": "rigid", "shape": "box")";
    EXPECT_EQ(complaintOf(box + R"(, "draw": "shapes" })"),
              "/objects/0/draw: \"shapes\" is unknown; did you mean \"shape\"?");
    EXPECT_EQ(complaintOf(box + "}", R"("materials": { "sea": { "fluid": true, "draw": "shape" } }, )"),
              "/materials/sea/draw: a fluid has no shape; take \"surface\" or \"particles\"");
}

}  // namespace
}  // namespace knuckle::test
