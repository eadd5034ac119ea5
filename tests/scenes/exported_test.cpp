#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>

#include "app/export/bvh.h"
#include "app/export/gltf.h"
#include "app/json/json.h"
#include "tests/cli/export/add_frame.h"
#include "tests/places.h"
#include "tests/scenes/scene_watch.h"
#include "tests/temp_folder.h"

namespace knuckle::test {

namespace {

constexpr double RATE = 60.0;

/// The skinned mesh of a GLB file, as stored.
struct StoredSkin {
    explicit StoredSkin(const std::string& path) : bytes(readText(path))
    {
        uint32_t jsonSize = 0;
        std::memcpy(&jsonSize, bytes.data() + 12, sizeof(jsonSize));
        json = parseJson(bytes.substr(20, jsonSize), "GLB");
        binary = 20 + jsonSize + 8;
        const auto& skinned = *std::ranges::find_if(json["nodes"], [](const Json& n) { return n.contains("skin"); });
        const Json attributes = json["meshes"][skinned["mesh"].get<size_t>()]["primitives"][0]["attributes"];
        positions = read<float>(attributes["POSITION"], 3);
        joints = read<uint8_t>(attributes["JOINTS_0"], 4);
        weights = read<float>(attributes["WEIGHTS_0"], 4);
        const Json& skin = json["skins"][skinned["skin"].get<size_t>()];
        binds = read<float>(skin["inverseBindMatrices"], 16);
        for (const Json& joint : skin["joints"])
            names.push_back(json["nodes"][joint.get<size_t>()]["name"].get<std::string>());
    }

    template <typename T>
    std::vector<T> read(const Json& index, size_t width) const
    {
        const Json& accessor = json["accessors"][index.get<size_t>()];
        const Json& view = json["bufferViews"][accessor["bufferView"].get<size_t>()];
        std::vector<T> values(width * accessor["count"].get<size_t>());
        const size_t offset = binary + view.value("byteOffset", 0u) + accessor.value("byteOffset", 0u);
        std::memcpy(values.data(), bytes.data() + offset, values.size() * sizeof(T));
        return values;
    }

    /// Place of a vertex for joints in `poses`.
    Vector3f placeOf(size_t vertex, const std::map<std::string, Eigen::Matrix4f>& poses) const
    {
        const Eigen::Vector4f rest(positions[3 * vertex], positions[3 * vertex + 1], positions[3 * vertex + 2], 1.0f);
        Eigen::Vector4f sum = Eigen::Vector4f::Zero();
        for (size_t i = 4 * vertex; i < 4 * vertex + 4; ++i) {
            const Eigen::Map<const Eigen::Matrix4f> bind(&binds[16 * size_t{joints[i]}]);
            sum += weights[i] * (poses.at(names[joints[i]]) * (bind * rest));
        }
        return sum.head<3>();
    }

    std::string bytes;
    Json json;
    size_t binary = 0;
    std::vector<float> positions, weights, binds;
    std::vector<uint8_t> joints;
    std::vector<std::string> names;
};

/// The dancer of a film of 1.2 s, let go in its leap after 0.4 s; its files, and the places of bodies.
class ExportedDance : public ::testing::Test {
protected:
    ExportedDance()
        : scene(loadScene(
              folder.write("dance.json", R"({ "diameter": 0.045, "colliders": [{ "type": "plane" }], "objects": [
            { "type": "actor", "name": "dancer", "file": ")" +
                                             inSource("assets/models/humanoid.glb") + R"(",
              "animation": { "clip": "dance", "start": 5 }, "release": { "time": 0.4 } }] })")))
    {
        GltfExport gltf(folder.path("out.glb"));
        BvhExport bvh(folder.path("out.bvh"));
        gltf.begin(scene);
        bvh.begin(scene);
        Solver solver(gpu(), scene.world);
        for (uint32_t frame = 0; frame < 72; ++frame) {
            states.push_back(solver.readBodies());
            addFrame(gltf, scene.world, states.back());
            addFrame(bvh, scene.world, states.back());
            for (uint32_t step = 0; step < scene.stepsPerFrame; ++step) solver.step();
        }
        gltf.finish();
        bvh.finish();
    }

    /// Poses by the bones' names at frames of the film, without those in between.
    static std::map<uint32_t, std::map<std::string, Eigen::Matrix4f>> posesOf(const Model& model)
    {
        std::map<uint32_t, std::map<std::string, Eigen::Matrix4f>> poses;
        const Clip& clip = model.clips.at(0);
        for (size_t k = 0; k < clip.keyTimes.size(); ++k) {
            const double frame = RATE * clip.keyTimes[k];
            if (std::abs(frame - std::round(frame)) > 1e-3) continue;
            for (size_t b = 0; b < model.bones.size(); ++b)
                poses[static_cast<uint32_t>(std::lround(frame))][model.bones[b].name] = clip.poses[k][b];
        }
        return poses;
    }

    TempFolder folder;
    Scene scene;
    std::vector<std::vector<BodyState>> states;
};

/// Keys may be off by 0.01 mm and 2e-5 rad, over chains of a metre and more.
TEST_F(ExportedDance, TheSkinOfTheFileIsWhereTheDrawnOneIs)
{
    const StoredSkin stored(folder.path("out.glb"));
    const SkinMesh& drawn = *scene.world.skins.at(0).mesh;
    ASSERT_EQ(stored.positions.size(), 3 * drawn.vertices.size());
    const auto frames = posesOf(importModel(folder.path("out.glb"), {.fit = {.scale = 1.0}}));
    ASSERT_GE(frames.size(), 71u);
    float worst = 0.0f;
    for (const auto& [frame, poses] : frames)
        for (size_t v = 0; v < drawn.vertices.size(); v += 7) {
            const SkinVertex& vertex = drawn.vertices[v];
            Vector3f place(0, 0, 0);
            for (size_t i = 0; i < 4; ++i)
                if (vertex.weights[i] > 0.0f)
                    place += vertex.weights[i] *
                             (motionOf(scene.world.bodies[vertex.bodies[i]], states[frame][vertex.bodies[i]]) *
                              vertex.position);
            worst = std::max(worst, (stored.placeOf(v, poses) - place).norm());
        }
    EXPECT_LT(worst, 1e-4f);
}

/// For a figure of 1.75 m.
TEST_F(ExportedDance, JointsOfTheMotionFileAreWhereTheyWere)
{
    const Model read = importModel(folder.path("out.bvh"), {.fit = {.scale = 0.01}});
    const Rig rig = rigsOf(scene, false).at(0);
    const auto headOf = [&](size_t bone, size_t frame) -> Vector3f {
        const uint32_t body = rig.bodies[bone];
        return motionOf(scene.world.bodies[body], states[frame][body]) *
               Vector3f(rig.model.bones[bone].restPose.block<3, 1>(0, 3));
    };
    const Clip& clip = read.clips.at(0);
    ASSERT_NEAR(clip.duration, 71.0 / RATE, 1e-4);
    float worst = 0.0f;
    size_t found = 0;
    for (size_t b = 0; b < rig.bodies.size(); ++b) {
        const auto bone = std::ranges::find(read.bones, rig.model.bones[b].name, &Bone::name);
        if (bone == read.bones.end()) continue;
        ++found;
        for (size_t k = 0; k < clip.keyTimes.size(); ++k) {
            // Import also samples between frames, where a blow at a frame is off the line by a centimetre.
            const double frame = std::clamp(RATE * clip.keyTimes[k], 0.0, 70.999);
            const auto before = static_cast<size_t>(frame);
            const auto part = static_cast<float>(frame - std::floor(frame));
            const Vector3f head = (1 - part) * headOf(b, before) + part * headOf(b, before + 1);
            const Vector3f is = clip.poses[k][static_cast<size_t>(bone - read.bones.begin())].block<3, 1>(0, 3);
            worst = std::max(worst, (is - head).norm());
        }
    }
    EXPECT_EQ(found, rig.bodies.size());
    EXPECT_LT(worst, 0.01f * 1.75f);
}

}  // namespace

}  // namespace knuckle::test
