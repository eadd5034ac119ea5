#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

#include "sim/base/errors.h"
#include "sim/rig/bodies/make_actor.h"
#include "sim/rig/import/import.h"
#include "tests/message_of.h"
#include "tests/temp_folder.h"

namespace knuckle {
namespace {

using Eigen::Vector3f;

struct Joint {
    const char* name;
    int parent;
    Vector3f place;  ///< [m], z up.
};

/// A person of 1.7 m whose last bones have no ends.
const std::vector<Joint> PERSON{{"hips", -1, {0, 0, 0.95f}},
                                {"spine", 0, {0, 0, 1.15f}},
                                {"chest", 1, {0, 0, 1.3f}},
                                {"neck", 2, {0, 0, 1.5f}},
                                {"head", 3, {0, 0, 1.6f}},
                                {"upper_arm.L", 2, {0.18f, 0, 1.45f}},
                                {"forearm.L", 5, {0.45f, 0, 1.45f}},
                                {"hand.L", 6, {0.7f, 0, 1.45f}},
                                {"upper_arm.R", 2, {-0.18f, 0, 1.45f}},
                                {"forearm.R", 8, {-0.45f, 0, 1.45f}},
                                {"hand.R", 9, {-0.7f, 0, 1.45f}},
                                {"thigh.L", 0, {0.1f, 0, 0.9f}},
                                {"shin.L", 11, {0.1f, 0, 0.5f}},
                                {"foot.L", 12, {0.1f, 0, 0.08f}},
                                {"thigh.R", 0, {-0.1f, 0, 0.9f}},
                                {"shin.R", 14, {-0.1f, 0, 0.5f}},
                                {"foot.R", 15, {-0.1f, 0, 0.08f}}};

/// From its parent.
Vector3f offsetOf(const Joint& joint)
{
    return joint.parent < 0 ? joint.place : Vector3f(joint.place - PERSON[static_cast<size_t>(joint.parent)].place);
}

std::string words(const Vector3f& v, const char* between)
{
    return std::to_string(v.x()) + between + std::to_string(v.y()) + between + std::to_string(v.z());
}

/// A clip of Doom 3: text, with its skeleton in the frame of the clip. A forearm bends.
std::string md5anim()
{
    const std::string count = std::to_string(PERSON.size());
    std::string text = "MD5Version 10\ncommandline \"\"\n\nnumFrames 2\nnumJoints " + count +
                       "\nframeRate 2\nnumAnimatedComponents " + std::to_string(6 * PERSON.size()) +
                       "\n\nhierarchy {\n";
    std::string bounds = "bounds {\n", base = "baseframe {\n", frames;
    for (size_t j = 0; j < PERSON.size(); ++j) {
        text += std::string("\t\"") + PERSON[j].name + "\"\t" + std::to_string(PERSON[j].parent) + " 63 " +
                std::to_string(6 * j) + "\t//\n";
        base += "\t( " + words(100.0f * offsetOf(PERSON[j]), " ") + " ) ( 0 0 0 )\n";
    }
    for (int frame = 0; frame < 2; ++frame) {
        bounds += "\t( -80 -20 0 ) ( 80 20 180 )\n";
        frames += "\nframe " + std::to_string(frame) + " {\n";
        for (const Joint& joint : PERSON) {
            const bool bends = frame == 1 && std::string(joint.name) == "forearm.L";
            frames += "\t" + words(100.0f * offsetOf(joint), " ") + (bends ? " 0 -0.5 0\n" : " 0 0 0\n");
        }
        frames += "}\n";
    }
    return text + "}\n\n" + bounds + "}\n\n" + base + "}\n" + frames;
}

/// The same as glTF, without a mesh, and with other things that scenes contain. @param moved the joint that turns.
std::string gltf(size_t moved)
{
    std::string nodes = R"({ "name": "Scene", "children": [1, 3] },
        { "name": "Armature", "rotation": [-0.70710678, 0, 0, 0.70710678], "children": [4, 2] },
        { "name": "empty", "translation": [5, 0, 0] }, { "name": "Camera", "translation": [0, 9, 9] })";
    constexpr size_t FIRST = 4;
    for (size_t j = 0; j < PERSON.size(); ++j) {
        std::string children;
        for (size_t c = 0; c < PERSON.size(); ++c)
            if (PERSON[c].parent == static_cast<int>(j))
                children += (children.empty() ? "" : ", ") + std::to_string(FIRST + c);
        nodes += std::string(",\n{ \"name\": \"") + PERSON[j].name + "\", \"translation\": [" +
                 words(offsetOf(PERSON[j]), ", ") + "]" +
                 (children.empty() ? "" : ", \"children\": [" + children + "]") + " }";
    }
    return R"({ "asset": { "version": "2.0" }, "scene": 0, "scenes": [{ "nodes": [0] }], "nodes": [)" + nodes +
           R"(], "animations": [{ "name": "wave", "samplers": [{ "input": 0, "output": 1 }],
           "channels": [{ "sampler": 0, "target": { "path": "rotation", "node": )" +
           std::to_string(FIRST + moved) + R"( } }] }],
           "buffers": [{ "uri": "wave.bin", "byteLength": 40 }],
           "bufferViews": [{ "buffer": 0, "byteOffset": 0, "byteLength": 8 },
                           { "buffer": 0, "byteOffset": 8, "byteLength": 32 }],
           "accessors": [{ "bufferView": 0, "componentType": 5126, "count": 2, "type": "SCALAR", "min": [0],
                           "max": [1] },
                         { "bufferView": 1, "componentType": 5126, "count": 2, "type": "VEC4" }] })";
}

/// Two times and two turns.
std::string gltfKeys()
{
    const float keys[10] = {0, 1, 0, 0, 0, 1, 0, -0.5f, 0, 0.8660254f};
    std::string bytes(sizeof keys, '\0');
    std::memcpy(bytes.data(), keys, sizeof keys);
    return bytes;
}

/// Checks that it is a standing person with a head, hands and feet, and that a clip moves it.
void expectPerson(const Model& model, const std::string& clip)
{
    std::vector<std::string> names;
    for (const Bone& bone : model.bones) names.push_back(bone.name);
    std::vector<std::string> wanted;
    for (const Joint& joint : PERSON) wanted.push_back(joint.name);
    std::ranges::sort(names);
    std::ranges::sort(wanted);
    EXPECT_EQ(names, wanted);
    ASSERT_EQ(model.clips.size(), 1u);
    EXPECT_EQ(model.clips[0].name, clip);
    EXPECT_GT(model.clips[0].duration, 0.0);
    EXPECT_NE(model.clips[0].poses.front(), model.clips[0].poses.back());
    const Actor actor = makeActor(model, {.name = {}, .voxels = {.diameter = 0.03f}, .articulation = {}});
    EXPECT_EQ(actor.bodies.front().name, "hips");
    for (const char* end : {"head", "hand.L", "hand.R", "foot.L", "foot.R", "forearm.L", "shin.R"})
        EXPECT_EQ(std::ranges::count(actor.bodies, end, &ActorBody::name), 1) << end;
    Eigen::AlignedBox3f box;
    for (const Vector3f& p : actor.particles) box.extend(p);
    EXPECT_NEAR(box.sizes().y(), 1.75f, 0.15f);
    EXPECT_NEAR(box.sizes().x(), 1.65f, 0.15f);
    EXPECT_LT(box.sizes().z(), 0.4f);
}

TEST(ClipFile, ADoom3ClipIsAFigureAsThatOfABvhIs)
{
    const test::TempFolder folder;
    expectPerson(importModel(folder.write("wave.md5anim", md5anim())), "clip 0");
    expectPerson(importModel(folder.path("wave.md5anim"), {.surface = true}), "clip 0");
}

TEST(ClipFile, AGltfWithoutAMeshIsOneToo)
{
    const test::TempFolder folder;
    folder.write("wave.bin", gltfKeys());
    // With fixed hips, and with moving ones.
    for (const size_t moved : {size_t{6}, size_t{0}})
        expectPerson(importModel(folder.write("wave.gltf", gltf(moved))), "wave");
}

TEST(ClipFile, OneOfItsSkeletonsCanBeAskedFor)
{
    const test::TempFolder folder;
    folder.write("wave.bin", gltfKeys());
    ImportOptions options;
    options.pick.skeleton = "hips";
    expectPerson(importModel(folder.write("wave.gltf", gltf(0)), options), "wave");
    options.pick.skeleton = "pelvis";
    EXPECT_EQ(test::messageOf<SkeletonError>([&] { importModel(folder.path("wave.gltf"), options); }),
              folder.path("wave.gltf") + ": it has no skeleton 'pelvis', but one: hips (17 bones)");
}

}  // namespace
}  // namespace knuckle
