#include <gtest/gtest.h>

#include <algorithm>

#include "sim/base/errors.h"
#include "sim/rig/bodies/make_actor.h"
#include "sim/rig/import/import.h"
#include "sim/rig/import/skeleton/rest_pose.h"
#include "tests/message_of.h"
#include "tests/temp_folder.h"
#include "tools/dog/dog.h"
#include "tools/spider/spider.h"

namespace knuckle {
namespace {

using test::TempFolder;

/// A joint of a BVH file and what hangs on it.
std::string joint(const std::string& name, const std::string& offset, const std::string& inside)
{
    return "JOINT " + name + "\n{\nOFFSET " + offset + "\nCHANNELS 3 Zrotation Xrotation Yrotation\n" + inside + "}\n";
}

std::string endSite(const std::string& offset)
{
    return "End Site\n{\nOFFSET " + offset + "\n}\n";
}

std::string leg(const std::string& side, const std::string& x)
{
    return joint(side + "UpLeg", x + " -8 0",
                 joint(side + "Leg", "0 -42 0", joint(side + "Foot", "0 -40 0", endSite("0 -5 14"))));
}

/// Hips, head and legs of a figure of 1.7 m in centimetres.
std::string hips(const std::string& offset, const std::string& headEnd)
{
    return joint("Hips", offset,
                 joint("Spine", "0 30 0", joint("Neck", "0 25 0", joint("Head", "0 10 0", endSite(headEnd)))) +
                     leg("Left", "15") + leg("Right", "-15"));
}

/// @param body text of what hangs on the root. @param turns of each joint about z in the second frame [degrees].
std::string bvh(const std::string& root, const std::string& body, const std::vector<float>& turns)
{
    std::string still = "0 0 0 0 0 0", moved = "0 0 0 0 0 0";
    for (const float turn : turns) {
        still += " 0 0 0";
        moved += " " + std::to_string(turn) + " 0 0";
    }
    return "HIERARCHY\nROOT " + root +
           "\n{\nOFFSET 0 0 0\nCHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation " + "Yrotation\n" + body +
           "}\nMOTION\nFrames: 2\nFrame Time: 0.05\n" + still + "\n" + moved + "\n";
}

Model import(const std::string& text)
{
    const TempFolder folder;
    return importModel(folder.write("figure.bvh", text));
}

const std::vector<float> STILL(10, 0.0f);

TEST(SkeletonFile, whatLeadsToTheHipsHasNoBody)
{
    const Model model = import(
        bvh("Reference", joint("Trajectory", "0 0 0", hips("0 95 0", "0 20 0")), std::vector<float>(11, 0.0f)));
    const Actor actor = makeActor(model, {.name = {}, .voxels = {.diameter = 0.04f}, .articulation = {}});
    ASSERT_FALSE(actor.bodies.empty());
    EXPECT_EQ(actor.bodies.front().name, "Hips");
    for (const ActorBody& body : actor.bodies) {
        EXPECT_NE(body.name, "Trajectory");
        EXPECT_EQ(std::ranges::count(body.mergedBones, "Trajectory"), 0) << body.name;
    }
    // Between the feet, which are 0.3 m apart, there is nothing.
    for (const Vector3f& p : actor.particles) EXPECT_FALSE(p.y() < 0.6f && std::abs(p.x()) < 0.02f) << p.transpose();
}

TEST(SkeletonFile, skullThatLiesOnItsSideGoesOnAsTheNeck)
{
    for (const char* end : {"0 20 0", "20 0 0", "0 0 -20"}) {
        const Model model = import(bvh("Root", hips("0 95 0", end), STILL));
        float highest = 0.0f, widest = 0.0f;
        for (const Vector3f& v : model.vertices) {
            highest = std::max(highest, v.y());
            if (v.y() > 1.5f) widest = std::max({widest, std::abs(v.x()), std::abs(v.z())});
        }
        // Hips 0.95, spine 0.3, neck 0.25, head 0.1 and 0.2, and a skull's radius of 0.05 of the figure's height.
        EXPECT_NEAR(highest, 1.89f, 0.02f) << end;
        EXPECT_LT(widest, 0.12f) << end;
    }
}

TEST(SkeletonFile, restPoseThatIsNoneIsReplacedByAClipsPose)
{
    // All bones along x: the legs lie beside the spine, as recorders write them; in the second frame the spine stands.
    const auto straight = [](const std::string& side) {
        return joint(side + "UpLeg", "8 0 0",
                     joint(side + "Leg", "42 0 0", joint(side + "Foot", "40 0 0", endSite("14 0 0"))));
    };
    const std::string body = joint(
        "Hips", "0 95 0",
        joint("Spine", "30 0 0", joint("Neck", "25 0 0", joint("Head", "10 0 0", endSite("20 0 0")))) +
            straight("Left") + straight("Right"));
    // Hips, Spine, Neck, Head, LeftUpLeg, ...: the spine up, the legs down and apart.
    const Model model = import(bvh("Root", body, {0, 90, 0, 0, -80, 0, 0, -100, 0, 0}));
    const auto told = [](const std::string& note) { return note.find("was taken") != std::string::npos; };
    EXPECT_TRUE(std::ranges::any_of(model.notes, told));
    float highest = 0.0f, lowest = 1.0f;
    for (const Bone& bone : model.bones) {
        highest = std::max(highest, bone.restPose(1, 3));
        lowest = std::min(lowest, bone.restPose(1, 3));
    }
    EXPECT_NEAR(lowest, 0.0f, 0.01f);
    // Between the two frames the import has poses of its own; it takes the first standing one.
    EXPECT_GT(highest, 1.2f);
}

TEST(SkeletonFile, goodRestPoseStays)
{
    const Model model = import(bvh("Root", hips("0 95 0", "0 20 0"), STILL));
    for (const std::string& note : model.notes) EXPECT_EQ(note.find("rest pose"), std::string::npos) << note;
}

/// Creatures with four or six legs are longer than high.
TEST(SkeletonFile, restPosesOfCreaturesStay)
{
    for (Model model : {makeDog(), makeSpider()}) {
        chooseRestPose(model, readAnatomy(model));
        EXPECT_EQ(model.poseFrom, "") << model.name;
        for (Bone& bone : model.bones) bone.restPose = Eigen::Matrix4f::Identity();
        chooseRestPose(model, readAnatomy(model));
        EXPECT_NE(model.poseFrom, "") << model.name;
    }
}

TEST(SkeletonFile, aClipHasASampleForEachOfItsFrames)
{
    std::string text = bvh("Root", hips("0 95 0", "0 20 0"), STILL), frame = "0 0 0 0 0 0";
    for (size_t i = 0; i < STILL.size(); ++i) frame += " 0 0 0";
    text = text.substr(0, text.find("Frames:")) + "Frames: 8\nFrame Time: 0.0166667\n";
    for (int i = 0; i < 8; ++i) text += frame + "\n";
    EXPECT_EQ(import(text).clips.at(0).poses.size(), 8u);
}

TEST(SkeletonFile, cloudOfMarkersIsRefused)
{
    std::string markers;
    for (int i = 0; i < 20; ++i)
        markers += joint("M" + std::to_string(i), std::to_string(i) + " 1 0", endSite("0 0 0"));
    const std::string message = test::messageOf<InputError>(
        [&] { import(bvh("Root", markers, std::vector<float>(20, 0.0f))); });
    EXPECT_NE(message.find("cloud of markers"), std::string::npos) << message;
}

TEST(SkeletonFile, byteOrderMarkChangesNothing)
{
    const std::string text = bvh("Root", hips("0 95 0", "0 20 0"), STILL);
    const Model plain = import(text), marked = import("\xEF\xBB\xBF" + text);
    EXPECT_EQ(plain.bones.size(), marked.bones.size());
    EXPECT_EQ(plain.vertices, marked.vertices);
}

}  // namespace
}  // namespace knuckle
