#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <fstream>

#include "sim/base/errors.h"
#include "sim/rig/bodies/make_actor.h"
#include "sim/rig/gltf/glb.h"
#include "sim/rig/import/import.h"
#include "tests/message_of.h"
#include "tests/temp_folder.h"
#include "tools/humanoid/humanoid.h"

namespace knuckle {
namespace {

using Eigen::Vector3f;

/// Boxes in the format of an .obj: each face has its own corners, as programs write them for sharp edges.
class ObjBoxes {
public:
    ObjBoxes& object(const std::string& name)
    {
        text += "o " + name + "\n";
        return *this;
    }
    ObjBoxes& box(const Vector3f& low, const Vector3f& high)
    {
        constexpr std::array<std::array<int, 4>, 6> FACES{
            {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
        for (const auto& face : FACES) {
            for (const int corner : face) {
                text += "v";
                for (int k = 0; k < 3; ++k) text += " " + std::to_string((corner >> k & 1 ? high : low)[k]);
                text += "\n";
            }
            text += "f -4 -3 -2 -1\n";
        }
        return *this;
    }
    std::string text;
};

class Parts : public testing::Test {
protected:
    Model import(const std::string& text) const
    {
        ImportOptions options;
        options.pick.split = true;
        return importModel(folder_.write("parts.obj", text), options);
    }
    static std::vector<std::string> names(const Model& model)
    {
        std::vector<std::string> names;
        for (const Bone& bone : model.bones) names.push_back(bone.name);
        return names;
    }
    static Actor make(const Model& model, float diameter)
    {
        return makeActor(model, {.name = {}, .voxels = {.diameter = diameter}, .articulation = {}});
    }
    test::TempFolder folder_;
};

TEST_F(Parts, AreWhatTrianglesAndCornersConnectAndHaveTheirObjectsNames)
{
    ObjBoxes boxes;
    boxes.object("stones").box({0, 0, 0}, {1, 1, 1}).box({2, 0, 0}, {3, 1, 1});
    boxes.object("lid").box({0, 1, 0}, {1, 1.2f, 1});
    const Model model = import(boxes.text);
    EXPECT_EQ(names(model), (std::vector<std::string>{"stones_1", "stones_2", "lid"}));
    EXPECT_TRUE(model.isSplit);
    ASSERT_EQ(model.skin.size(), model.vertices.size());
    for (size_t v = 0; v < model.vertices.size(); ++v) {
        const uint32_t wanted = v >= 48 ? 2u : model.vertices[v].x() > 1.5f ? 1u : 0u;
        EXPECT_EQ(model.skin[v].bones[0], wanted) << v;
        EXPECT_EQ(model.skin[v].weights[0], 1.0f);
    }
    EXPECT_TRUE(model.notes.empty()) << model.notes[0];
}

TEST_F(Parts, WithoutANameAreNumbered)
{
    ObjBoxes boxes;
    boxes.box({0, 0, 0}, {1, 1, 1}).box({2, 0, 0}, {3, 1, 1});
    EXPECT_EQ(names(import(boxes.text)), (std::vector<std::string>{"part_1", "part_2"}));
}

TEST_F(Parts, OfAGltfWithoutNamesAreNumberedToo)
{
    // Two tetrahedra in one mesh.
    std::string bytes;
    const auto append = [&](auto value) { bytes.append(reinterpret_cast<const char*>(&value), sizeof value); };
    for (const float x : {0.0f, 2.0f})
        for (const Vector3f& v : {Vector3f(x, 0, 0), Vector3f(x + 1, 0, 0), Vector3f(x, 1, 0), Vector3f(x, 0, 1)})
            for (int k = 0; k < 3; ++k) append(v[k]);
    for (const uint16_t first : {uint16_t{0}, uint16_t{4}})
        for (const int corner : {0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2}) append(static_cast<uint16_t>(first + corner));
    std::ofstream(folder_.path("two.bin"), std::ios::binary) << bytes;
    ImportOptions options;
    options.pick.split = true;
    const Model model = importModel(folder_.write("two.gltf", R"({ "asset": { "version": "2.0" }, "scene": 0,
        "scenes": [{ "nodes": [0] }], "nodes": [{ "mesh": 0 }], "buffers": [{ "uri": "two.bin", "byteLength": 144 }],
        "meshes": [{ "primitives": [{ "attributes": { "POSITION": 0 }, "indices": 1 }] }],
        "bufferViews": [{ "buffer": 0, "byteLength": 96 }, { "buffer": 0, "byteOffset": 96, "byteLength": 48 }],
        "accessors": [{ "bufferView": 0, "componentType": 5126, "count": 8, "type": "VEC3", "min": [0, 0, 0],
                        "max": [3, 1, 1] },
                      { "bufferView": 1, "componentType": 5123, "count": 24, "type": "SCALAR" }] })"),
                                    options);
    EXPECT_EQ(names(model), (std::vector<std::string>{"part_1", "part_2"}));
}

TEST_F(Parts, BecomeBodiesWithoutJointsOfTheirOwnParticles)
{
    ObjBoxes boxes;
    boxes.object("hand.L").box({0, 0, 0}, {1, 1, 1}).object("hand.R").box({1, 0, 0}, {2.1f, 1, 1});
    const Actor actor = make(import(boxes.text), 0.1f);
    ASSERT_EQ(actor.bodies.size(), 2u);
    EXPECT_TRUE(actor.joints.empty());
    std::vector<int> uses(actor.particles.size(), 0);
    for (size_t b = 0; b < 2; ++b) {
        EXPECT_EQ(actor.bodies[b].name, b == 0 ? "hand.L" : "hand.R");
        EXPECT_EQ(actor.bodies[b].parent, -1);
        EXPECT_NEAR(static_cast<double>(actor.bodies[b].particles.size()), 1050.0, 200.0);
        for (const uint32_t p : actor.bodies[b].particles) {
            ++uses[p];
            EXPECT_EQ(actor.particles[p].x() > 1.0f, b == 1);
        }
    }
    EXPECT_TRUE(std::ranges::all_of(uses, [](int n) { return n == 1; }));
}

TEST_F(Parts, OfFewParticlesGoToTheNearest)
{
    ObjBoxes boxes;
    boxes.object("near").box({0, 0, 0}, {1, 1, 1}).object("far").box({3, 0, 0}, {4, 1, 1});
    boxes.object("bolt").box({3.4f, 1, 0.4f}, {3.5f, 1.1f, 0.5f});
    const Actor actor = make(import(boxes.text), 0.1f);
    ASSERT_EQ(actor.bodies.size(), 2u);
    EXPECT_TRUE(actor.bodies[0].mergedBones.empty());
    EXPECT_EQ(actor.bodies[1].mergedBones, std::vector<std::string>{"bolt"});
    EXPECT_EQ(actor.notes, std::vector<std::string>{"Parts of less than 12 particles went to the nearest: bolt."});
    // So coarse that no part is large: all become one body.
    EXPECT_EQ(make(import(boxes.text), 0.6f).bodies.size(), 1u);
}

TEST_F(Parts, OfAModelWithASkeletonAreItsBodiesAlready)
{
    std::ofstream(folder_.path("figure.glb"), std::ios::binary) << toGlb(makeHumanoid());
    ImportOptions options;
    options.pick.split = true;
    EXPECT_EQ(test::messageOf<InputError>([&] { importModel(folder_.path("figure.glb"), options); }),
              folder_.path("figure.glb") + ": it has a skeleton, which says what its bodies are: leave `split` away");
}

}  // namespace
}  // namespace knuckle
