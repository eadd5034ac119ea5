#include "app/export/gltf.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "sim/base/errors.h"
#include "sim/rig/gltf/key_reduction.h"
#include "tests/cli/export/add_frame.h"
#include "tests/message_of.h"
#include "tests/places.h"
#include "tests/temp_folder.h"

namespace knuckle::test {
namespace {

/// States of a world whose bodies turn about an axis through the origin and rise.
std::vector<BodyState> turned(const World& world, float angle)
{
    const Eigen::AngleAxisf turn(angle, Vector3f(1, 2, 0.5f).normalized());
    std::vector<BodyState> states;
    for (const Body& body : world.bodies) {
        BodyState state;
        state.rotation = Quaternionf(turn);
        state.position = turn * body.restCentre + Vector3f(0, angle, 0);
        states.push_back(state);
    }
    return states;
}

TEST(GltfExport, ReadBackTheSkeletonMovesAsTheBodiesDid)
{
    const TempFolder folder;
    const Scene scene = loadScene(folder.write("scene.json", R"({ "fps": 30, "diameter": 0.08, "objects": [
        { "type": "actor", "name": "figure", "file": ")" + inSource("assets/models/humanoid.glb") +
                                                                 R"(" },
        { "type": "joined", "name": "pair", "position": [3, 0, 0] }] })"));
    const std::string path = folder.path("out.glb");
    GltfExport out(path);
    out.begin(scene);
    constexpr int FRAMES = 31;
    const auto angleAt = [](int frame) { return 0.1f * static_cast<float>(frame); };
    for (int f = 0; f < FRAMES; ++f) addFrame(out, scene.world, turned(scene.world, angleAt(f)));
    out.finish();

    const Model before = importModel(inSource("assets/models/humanoid.glb"), {.clips = false});
    const Model after = importModel(path, {.fit = {.scale = 1.0}, .surface = true});
    ASSERT_EQ(after.clips.size(), 1u);
    EXPECT_EQ(after.clips[0].name, "simulation");
    EXPECT_NEAR(after.clips[0].duration, 1.0, 1e-6);
    EXPECT_EQ(after.bones.size(), before.bones.size()) << "the figure's; the pair has a skeleton of its own";
    const ImportOptions everything{.fit = {.scale = 1.0}, .pick = {.skeleton = ALL_SKELETONS}};
    EXPECT_GE(importModel(path, everything).bones.size(), before.bones.size() + 2) << "with two bodies";
    const Clip& clip = after.clips[0];
    size_t checked = 0;
    for (const Bone& bone : before.bones) {
        const auto found = std::ranges::find(after.bones, bone.name, &Bone::name);
        ASSERT_NE(found, after.bones.end()) << bone.name;
        for (size_t k = 0; k < clip.keyTimes.size(); ++k) {
            // Import also samples between frames, where a line cuts the arc short.
            const double frame = 30.0 * clip.keyTimes[k];
            if (std::abs(frame - std::round(frame)) > 1e-3) continue;
            ++checked;
            const auto angle = 3.0f * static_cast<float>(clip.keyTimes[k]);
            const Vector3f head = bone.restPose.block<3, 1>(0, 3);
            const Vector3f wanted = Eigen::AngleAxisf(angle, Vector3f(1, 2, 0.5f).normalized()) * head +
                                    Vector3f(0, angle, 0);
            const Vector3f is = clip.poses[k][static_cast<size_t>(found - after.bones.begin())].block<3, 1>(0, 3);
            // Places may be off by 0.01 mm, and turns by 2e-5 of 2 m.
            ASSERT_LT((is - wanted).norm(), 1e-4f) << bone.name << " at " << clip.keyTimes[k];
        }
    }
    EXPECT_GE(checked, 30 * before.bones.size());
}

TEST(GltfExport, CopiesShareTheirMesh)
{
    const TempFolder folder;
    const auto sizeOf = [&](int copies) {
        const Scene scene = loadScene(
            folder.write("scene.json", R"({ "diameter": 0.08, "objects": [{ "type": "actor", "file": ")" +
                                           inSource("assets/models/humanoid.glb") + R"(", "repeat": { "counts": [)" +
                                           std::to_string(copies) + R"(, 1, 1], "spacing": [2, 2, 2] } }] })"));
        const std::string path = folder.path("out.glb");
        GltfExport out(path);
        out.begin(scene);
        addFrame(out, scene.world, turned(scene.world, 0.0f));
        out.finish();
        EXPECT_FALSE(importModel(path, {.fit = {.scale = 1.0}, .pick = {.skeleton = ALL_SKELETONS}}).vertices.empty());
        return readText(path).size();
    };
    EXPECT_LT(sizeOf(3), 1.2 * static_cast<double>(sizeOf(1)));
}

/// A crate without a skeleton: as an actor, and as a rigid object that is drawn by its mesh.
TEST(GltfExport, WhatHasNoSkeletonKeepsItsMesh)
{
    const TempFolder folder;
    const std::string crate = inSource("assets/models/crate.glb");
    const Model before = importModel(crate, {.surface = true});
    for (const char* object :
         {R"("type": "actor", "skin": "particles")", R"("type": "rigid", "shape": "mesh", "skin": "mesh")"}) {
        const Scene scene = loadScene(folder.write("scene.json", R"({ "diameter": 0.1, "objects": [{ "file": ")" +
                                                                     crate + "\", " + std::string(object) + " }] }"));
        GltfExport out(folder.path("out.glb"));
        out.begin(scene);
        addFrame(out, scene.world, turned(scene.world, 0.0f));
        out.finish();
        const Model after = importModel(folder.path("out.glb"), {.fit = {.scale = 1.0}, .surface = true});
        EXPECT_EQ(after.triangles.size(), before.triangles.size()) << object;
        EXPECT_EQ(after.surface.materials.size(), before.surface.materials.size()) << object;
        EXPECT_EQ(after.surface.textures.size(), before.surface.textures.size()) << object;
        EXPECT_EQ(after.bones.size(), 1u) << object;
    }
}

/// What triangles enclose [m3]; below 0 if they face inwards.
double enclosed(const Model& model)
{
    double six = 0.0;
    for (const auto& t : model.triangles) {
        const Vector3f &a = model.vertices[t[0]], &b = model.vertices[t[1]], &c = model.vertices[t[2]];
        six += double(a.dot(b.cross(c)));
    }
    return six / 6.0;
}

TEST(GltfExport, ShapesAreMeshesOfTheirSize)
{
    const TempFolder folder;
    const auto exported = [&](const std::string& shape) {
        const Scene scene = loadScene(folder.write("scene.json", R"({ "diameter": 0.1, "materials": { "all":
            { "draw": "shape" } }, "objects": [{ "type": "rigid", "material": "all", )" +
                                                                     shape + " }] }"));
        GltfExport out(folder.path("out.glb"));
        out.begin(scene);
        addFrame(out, scene.world, turned(scene.world, 0.0f));
        out.finish();
        return importModel(folder.path("out.glb"), {.fit = {.scale = 1.0}});
    };
    const Model box = exported(R"("shape": "box", "size": [0.4, 0.6, 0.8])");
    // All within r of a box: its volume, six slabs, twelve quarter cylinders, eight eighths of a ball. Roundings in
    // four parts lack a fortieth of themselves, which are a tenth of it.
    const double a = 0.3, b = 0.5, c = 0.7, r = 0.05, pi = std::numbers::pi;
    const double rounded = a * b * c + 2 * r * (a * b + b * c + c * a) + pi * r * r * (a + b + c) +
                           4.0 / 3.0 * pi * r * r * r;
    EXPECT_NEAR(enclosed(box), rounded, 0.004 * rounded);
    const auto low = [&](int axis) {
        float least = 1e9f;
        for (const Vector3f& v : box.vertices) least = std::min(least, v[axis]);
        return least;
    };
    EXPECT_NEAR(low(2), -0.4f, 1e-4f);
    const Model ball = exported(R"("shape": "sphere", "radius": 0.3)");
    // Chords of pi / 16 lie up to 0.5 % below the ball along both ways, a third of that in the mean.
    EXPECT_NEAR(enclosed(ball), 4.0 / 3.0 * pi * 0.027, 0.02 * 4.0 / 3.0 * pi * 0.027);
}

TEST(GltfExport, JointsOfASkinHaveOneRoot)
{
    const TempFolder folder;
    const Scene scene = loadScene(
        folder.write("pair.json", R"({ "objects": [{ "type": "joined", "name": "pair" }] })"));
    const std::string path = folder.path("pair.glb");
    GltfExport out(path);
    out.begin(scene);
    addFrame(out, scene.world, turned(scene.world, 0.0f));
    out.finish();
    const std::string bytes = readText(path);
    EXPECT_NE(bytes.find(R"("name":"pair root","children":[0,1])"), std::string::npos);
}

TEST(GltfExport, TellsWhatItLeavesOut)
{
    const TempFolder folder;
    const auto leftOut = [&](const std::string& more) {
        return GltfExport("out.glb").leftOut(
            loadScene(folder.write("scene.json", R"({ "objects": [{ "type": "joined" })" + more + " }")).world);
    };
    using Names = std::vector<std::string>;
    EXPECT_EQ(leftOut("]"), Names());
    EXPECT_EQ(leftOut(R"(, { "type": "cloth", "position": [0, 3, 0] }, { "type": "grains", "shape": "box",
                         "position": [0, 5, 0] }], "colliders": [{ "type": "plane" }])"),
              (Names{"colliders", "ropes and cloth", "grains"}));
    EXPECT_EQ(leftOut(R"(, { "type": "soft", "shape": "box", "position": [0, 5, 0] },
                         { "type": "fluid", "shape": "box", "position": [5, 5, 0] }])"),
              (Names{"soft bodies", "fluids"}));
}

TEST(GltfExport, ASceneWithoutBodiesIsRefused)
{
    const TempFolder folder;
    const Scene scene = loadScene(folder.write("water.json", R"({ "materials": { "water": { "fluid": true } },
        "objects": [{ "type": "fluid", "shape": "box", "size": [0.5, 0.5, 0.5], "material": "water" }] })"));
    EXPECT_EQ(messageOf<InputError>([&] { GltfExport(folder.path("out.glb")).begin(scene); }),
              "--export gltf=" + folder.path("out.glb") + ": the scene has no bodies, which could be written");
    EXPECT_FALSE(std::filesystem::exists(folder.path("out.glb")));
}

TEST(KeyReduction, KeepsWhatALineCannotSay)
{
    std::vector<float> times;
    std::vector<Vector3f> straight, bent, wave;
    for (int k = 0; k <= 100; ++k) {
        const auto t = 0.01f * static_cast<float>(k);
        times.push_back(t);
        straight.push_back({t, 2 * t, 1});
        bent.push_back({std::abs(t - 0.37f), 0, 0});
        wave.push_back({std::sin(6.0f * t), 0, 0});
    }
    EXPECT_EQ(keysOf(times, straight, 1e-5f), (std::vector<size_t>{0, 100}));
    EXPECT_EQ(keysOf(times, bent, 1e-5f), (std::vector<size_t>{0, 37, 100}));
    const std::vector<size_t> keys = keysOf(times, wave, 1e-2f);
    EXPECT_LT(keys.size(), 40u);
    for (size_t i = 0; i + 1 < keys.size(); ++i)
        for (size_t k = keys[i]; k <= keys[i + 1]; ++k) {
            const float part = (times[k] - times[keys[i]]) / (times[keys[i + 1]] - times[keys[i]]);
            const Vector3f line = wave[keys[i]] + part * (wave[keys[i + 1]] - wave[keys[i]]);
            EXPECT_LE((line - wave[k]).norm(), 1e-2f);
        }
}

}  // namespace
}  // namespace knuckle::test
