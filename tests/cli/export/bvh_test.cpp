#include "app/export/bvh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <random>

#include "sim/base/errors.h"
#include "tests/cli/export/add_frame.h"
#include "tests/message_of.h"
#include "tests/places.h"
#include "tests/temp_folder.h"

namespace knuckle::test {
namespace {

using Eigen::Isometry3f;

/// Hips, spine, an arm of two bones, and a tail without a parent.
Rig figure()
{
    Rig rig;
    const auto add = [&](const char* name, int32_t parent, const Vector3f& head) {
        Bone bone{name, parent};
        bone.restPose.block<3, 1>(0, 3) = head;
        rig.model.bones.push_back(bone);
        rig.bodies.push_back(static_cast<uint32_t>(rig.bodies.size()));
    };
    add("hips", -1, {0, 1, 0});
    add("spine", 0, {0, 1.3f, 0.02f});
    add("arm", 1, {0.2f, 1.5f, 0});
    add("fore arm", 2, {0.5f, 1.5f, 0});
    add("tail", -1, {0, 0.9f, -0.1f});
    return rig;
}

/// Bones that turn about their heads by up to a full turn, while the first and the last move freely.
std::vector<std::vector<Isometry3f>> motionsOf(const Rig& rig, int count)
{
    std::mt19937 random(3);
    std::uniform_real_distribution<float> some(-1.0f, 1.0f);
    std::vector<std::vector<Isometry3f>> frames;
    for (int f = 0; f < count; ++f) {
        std::vector<Isometry3f> frame;
        for (const Bone& bone : rig.model.bones) {
            const Vector3f head = bone.restPose.block<3, 1>(0, 3);
            const Vector3f axis = Vector3f(some(random), some(random), some(random)).normalized();
            // Some point straight up or down, where turns about Z and Y are the same.
            const float angle = f % 4 == 0 ? 0.5f * static_cast<float>(M_PI) : 3.0f * some(random);
            const Eigen::AngleAxisf turn(angle, f % 4 == 0 ? Vector3f(Vector3f::UnitX()) : axis);
            Isometry3f motion(Eigen::Translation3f(head) * turn * Eigen::Translation3f(-head));
            if (bone.parent >= 0) motion = frame[static_cast<size_t>(bone.parent)] * motion;
            else motion = Eigen::Translation3f(some(random), some(random), some(random)) * motion;
            frame.push_back(motion);
        }
        frames.push_back(std::move(frame));
    }
    return frames;
}

TEST(Bvh, ReadBackEveryJointIsWhereItWas)
{
    const TempFolder folder;
    const Rig rig = figure();
    // Holds each pose for a while, since import samples clips anew.
    constexpr size_t POSES = 20, HELD = 8;
    const auto poses = motionsOf(rig, POSES);
    std::vector<std::vector<Isometry3f>> frames;
    for (size_t f = 0; f < POSES * HELD; ++f) frames.push_back(poses[f / HELD]);
    const std::string path = folder.write("moves.bvh", bvhText(rig, frames, 60.0));
    const Model model = importModel(path, {.fit = {.scale = 0.01}});
    ASSERT_EQ(model.clips.size(), 1u);
    const Clip& clip = model.clips[0];
    EXPECT_NEAR(clip.duration, (POSES * HELD - 1) / 60.0, 1e-5);
    const char* names[] = {"hips", "spine", "arm", "fore_arm", "tail"};
    for (size_t b = 0; b < 5; ++b) {
        const auto bone = std::ranges::find(model.bones, names[b], &Bone::name);
        ASSERT_NE(bone, model.bones.end()) << names[b];
        const auto index = static_cast<size_t>(bone - model.bones.begin());
        for (size_t p = 0; p < POSES; ++p) {
            const double middle = (static_cast<double>(p * HELD) + 0.5 * (HELD - 1)) / 60.0;
            const auto key = std::ranges::lower_bound(clip.keyTimes, middle);
            ASSERT_NE(key, clip.keyTimes.end());
            const auto& pose = clip.poses[static_cast<size_t>(key - clip.keyTimes.begin())];
            const Vector3f wanted = poses[p][b] * Vector3f(rig.model.bones[b].restPose.block<3, 1>(0, 3));
            // Five decimals of centimetres and degrees, over a chain of a metre.
            EXPECT_LT((pose[index].block<3, 1>(0, 3) - wanted).norm(), 2e-5f) << names[b] << " in pose " << p;
        }
    }
}

TEST(Bvh, AnglesDoNotJumpWhereTheMotionDoesNot)
{
    Rig rig = figure();
    rig.model.bones.resize(1);
    rig.bodies.resize(1);
    std::vector<std::vector<Isometry3f>> frames;
    // Three turns about y, 5 degrees a frame.
    for (int f = 0; f < 216; ++f) {
        const float angle = static_cast<float>(M_PI) / 36.0f * static_cast<float>(f);
        frames.push_back({Isometry3f(Eigen::AngleAxisf(angle, Vector3f::UnitY()))});
    }
    const std::string text = bvhText(rig, frames, 60.0);
    EXPECT_NE(text.find(" 1075.00"), std::string::npos) << "the last angle: 215 times 5 degrees";
}

TEST(Bvh, OfSeveralActorsEachHasAFile)
{
    const TempFolder folder;
    const std::string figureFile = inSource("assets/models/humanoid.glb");
    const Scene scene = loadScene(folder.write("scene.json", R"({ "diameter": 0.08, "objects": [
        { "type": "actor", "name": "a", "file": ")" + figureFile +
                                                                 R"(" },
        { "type": "actor", "name": "b", "file": ")" + figureFile +
                                                                 R"(", "position": [2, 0, 0] }] })"));
    BvhExport both(folder.path("out.bvh"));
    both.begin(scene);
    addFrame(both, scene.world, std::vector<BodyState>(scene.world.bodies.size()));
    both.finish();
    EXPECT_TRUE(std::filesystem::exists(folder.path("out_a.bvh")));
    EXPECT_TRUE(std::filesystem::exists(folder.path("out_b.bvh")));
    const Scene bare = loadScene(folder.write("bare.json", R"({ "objects": [{ "type": "joined" }] })"));
    EXPECT_EQ(messageOf<InputError>([&] { BvhExport(folder.path("none.bvh")).begin(bare); }),
              "--export bvh=" + folder.path("none.bvh") + ": the scene has no actor, whose bones could be written");
    EXPECT_FALSE(std::filesystem::exists(folder.path("none.bvh")));
}

TEST(Bvh, EachActorHasAFileOfItsOwn)
{
    const TempFolder folder;
    std::string objects;
    for (const char* name : {"a", "a", "a_2", "b/c", "b_c"})
        objects += std::string(objects.empty() ? "" : ", ") + R"({ "type": "actor", "name": ")" + name +
                   R"(", "file": ")" + inSource("assets/models/humanoid.glb") + "\" }";
    const Scene scene = loadScene(folder.write("scene.json", R"({ "diameter": 0.08, "objects": [)" + objects + "] }"));
    BvhExport out(folder.path("out.bvh"));
    out.begin(scene);
    addFrame(out, scene.world, std::vector<BodyState>(scene.world.bodies.size()));
    out.finish();
    for (const char* name : {"a", "a_2", "a_2_2", "b_c", "b_c_2"})
        EXPECT_TRUE(std::filesystem::exists(folder.path(std::string("out_") + name + ".bvh"))) << name;
}

}  // namespace
}  // namespace knuckle::test
