#include <gtest/gtest.h>

#include <algorithm>

#include "sim/rig/import/import.h"
#include "tests/rig/import/fbx_text.h"
#include "tests/temp_folder.h"

namespace knuckle {
namespace {

using Eigen::Vector3d;
using test::FbxJoint;
using test::fbxPose;
using test::fbxText;

/// Hips, spine, head and legs of a figure of 1.7 m, whose left thigh a test changes, with what hangs on it.
std::vector<FbxJoint> figure()
{
    std::vector<FbxJoint> joints;
    const auto add = [&](const char* name, int parent, const Vector3d& place) {
        FbxJoint joint;
        joint.name = name;
        joint.parent = parent;
        joint.translation = place;
        joints.push_back(joint);
    };
    add("Hips", -1, {0, 0.95, 0});
    add("LeftUpLeg", 0, {0.09, -0.05, 0});
    add("LeftLeg", 1, {0, -0.42, 0.02});
    add("LeftFoot", 2, {0, -0.42, 0.03});
    add("LeftToeBase", 3, {0, -0.05, 0.13});
    add("RightUpLeg", 0, {-0.09, -0.05, 0});
    add("RightLeg", 5, {0, -0.42, 0.02});
    add("RightFoot", 6, {0, -0.42, 0.03});
    add("RightToeBase", 7, {0, -0.05, 0.13});
    add("Spine", 0, {0, 0.3, 0});
    add("Head", 9, {0, 0.3, 0});
    add("HeadEnd", 10, {0, 0.2, 0});
    joints[1].turns = {{-20, 10, 5}, {20, -30, 60}, {-20, 0, 0}};
    joints[2].turns = {{10, 0, 0}, {70, 0, 0}, {10, 0, 0}};
    joints[0].moves = {{0, 0.95, 0}, {0.1, 0.9, 0.3}, {0, 0.95, 0.6}};
    return joints;
}

Model import(const std::vector<FbxJoint>& joints)
{
    const test::TempFolder folder;
    ImportOptions options;
    options.fit.scale = 1.0;
    return importModel(folder.write("figure.fbx", fbxText(joints)), options);
}

/// Compares the file's poses at its keys, and at rest, with FBX's own formulas: places to 1e-4 of the figure's height,
/// the precision of assimp's floats, turns to 1e-3.
void expectPosed(const std::vector<FbxJoint>& joints, const std::string& what)
{
    const Model model = import(joints);
    ASSERT_EQ(model.clips.size(), 1u) << what;
    const Clip& clip = model.clips[0];
    for (const size_t key : {0, 1, 2}) {
        const auto found = std::ranges::find_if(clip.keyTimes,
                                                [&](double t) { return std::abs(t - 0.5 * double(key)) < 1e-6; });
        ASSERT_NE(found, clip.keyTimes.end()) << what;
        const auto& pose = clip.poses[static_cast<size_t>(found - clip.keyTimes.begin())];
        const std::vector<Eigen::Matrix4d> wanted = fbxPose(joints, key);
        for (size_t b = 0; b < model.bones.size(); ++b) {
            const auto joint = std::ranges::find(joints, model.bones[b].name, &FbxJoint::name);
            ASSERT_NE(joint, joints.end()) << model.bones[b].name;
            const Eigen::Matrix4d is = pose[b].cast<double>(),
                                  should = wanted[static_cast<size_t>(joint - joints.begin())];
            EXPECT_LT((Vector3d((is - should).topRightCorner<3, 1>()).norm()), 1.7e-4)
                << what << ", key " << key << ", " << joint->name;
            EXPECT_LT((Eigen::Matrix3d((is - should).topLeftCorner<3, 3>()).norm()), 1e-3)
                << what << ", key " << key << ", " << joint->name;
        }
    }
}

TEST(Fbx, PreAndPostRotationActOnceInClips)
{
    // In Mixamo's style; with values that readers may treat as zero absent, zero, and not zero.
    for (const auto& rest :
         {std::optional<Vector3d>{}, std::optional<Vector3d>{{0, 0, 0}}, std::optional<Vector3d>{{15, -10, 30}}}) {
        std::vector<FbxJoint> joints = figure();
        joints[1].preRotation = Vector3d(0, 0, 180);
        joints[1].rotation = rest;
        expectPosed(joints, "pre");
        joints[1].postRotation = Vector3d(20, -40, 70);
        expectPosed(joints, "pre and post");
        joints[1].preRotation.reset();
        expectPosed(joints, "post");
        joints[2].preRotation = Vector3d(30, 20, 10);
        expectPosed(joints, "post, pre below");
    }
}

TEST(Fbx, PivotsAndOffsetsActInClips)
{
    std::vector<FbxJoint> joints = figure();
    joints[1].rotationPivot = Vector3d(0.05, -0.1, 0.02);
    expectPosed(joints, "rotation pivot");
    joints[1].rotationOffset = Vector3d(0.01, 0.03, -0.02);
    joints[1].preRotation = Vector3d(0, 90, 20);
    joints[1].postRotation = Vector3d(0, 10, -45);
    expectPosed(joints, "rotation pivot and offset");
    joints[1].scaling = Vector3d(1.25, 1.25, 1.25);
    joints[1].scalingPivot = Vector3d(0, -0.2, 0);
    joints[1].scalingOffset = Vector3d(0, 0, 0.04);
    expectPosed(joints, "all");
}

TEST(Fbx, AllRotationOrders)
{
    for (int order = 0; order < 6; ++order) {
        std::vector<FbxJoint> joints = figure();
        joints[1].order = order;
        expectPosed(joints, "order " + std::to_string(order));
        joints[1].preRotation = Vector3d(10, 20, 30);
        expectPosed(joints, "order " + std::to_string(order) + " after pre");
        joints[1].rotationPivot = Vector3d(0.05, -0.1, 0.02);
        expectPosed(joints, "order " + std::to_string(order) + " about a pivot");
    }
}

TEST(Fbx, AxesWithoutCurvesAreWhatTheNodeSaysOrTold)
{
    std::vector<FbxJoint> joints = figure();
    FbxJoint& thigh = joints[1];
    thigh.rotation = Vector3d(5, 10, 20);
    thigh.turns = {{-20, 10, 20}, {20, 10, 20}, {-20, 10, 20}};
    thigh.turnAxes = "x";
    thigh.moves = {{0.09, -0.05, 0}, {0.09, 0.02, 0}, {0.09, -0.05, 0}};
    thigh.moveAxes = "y";
    thigh.preRotation = Vector3d(0, 0, 180);
    expectPosed(joints, "no pivots");
    const auto notes = [&] { return import(joints).clips.at(0).notes; };
    EXPECT_TRUE(notes().empty());
    // For a node with pivots assimp does not tell which axes have curves.
    thigh.rotationPivot = Vector3d(0.05, -0.1, 0.02);
    const std::string end = ", or nothing but the default, which is played; the node says otherwise. Bake all axes if "
                            "that is not meant.",
                      start = "Clip 'clip' has no keys for Lcl ";
    EXPECT_EQ(notes(), std::vector{start + "Translation of LeftUpLeg along x" + end});
    thigh.moveAxes = "xyz";
    EXPECT_EQ(notes(), std::vector{start + "Rotation of LeftUpLeg along y" + end});
    thigh.turnAxes = "xyz";
    EXPECT_TRUE(notes().empty());
    expectPosed(joints, "pivots, all axes");
}

TEST(Fbx, ScaleIsInheritedAsTheNodeSays)
{
    for (int type = 0; type < 3; ++type) {
        std::vector<FbxJoint> joints = figure();
        for (FbxJoint& joint : joints) joint.inherit = type;
        joints[1].scaling = Vector3d(1.2, 1.2, 1.2);
        joints[2].scaling = Vector3d(0.8, 0.8, 0.8);
        expectPosed(joints, "even scales, type " + std::to_string(type));
        joints[1].scaling = Vector3d(1.2, 0.7, 1.0);
        joints[2].scaling = Vector3d(0.8, 1.5, 1.1);
        expectPosed(joints, "uneven scales, type " + std::to_string(type));
        joints[1].preRotation = Vector3d(0, 0, 180);
        joints[2].rotationPivot = Vector3d(0.02, 0.1, 0);
        expectPosed(joints, "turned and about a pivot, type " + std::to_string(type));
    }
}

TEST(Fbx, AScaleOnEveryJointIsNotMultipliedWhereItIsNotInherited)
{
    // In Maya's style, a skeleton in metres under a node that scales it: each joint undoes its parent's scale.
    std::vector<FbxJoint> joints = figure();
    for (FbxJoint& joint : joints) {
        joint.scaling = Vector3d(0.01, 0.01, 0.01);
        joint.inherit = 2;
        joint.translation *= 100.0;
        for (Vector3d& move : joint.moves) move *= 100.0;
    }
    FbxJoint reference;
    reference.name = "Reference";
    reference.scaling = Vector3d(0.01, 0.01, 0.01);
    for (FbxJoint& joint : joints) ++joint.parent;
    joints.insert(joints.begin(), reference);
    const Model model = import(joints);
    float lowest = 1e9f, highest = -1e9f;
    for (uint32_t b = 0; b < model.bones.size(); ++b) {
        lowest = std::min(lowest, boneHead(model, b).y());
        highest = std::max(highest, boneHead(model, b).y());
    }
    EXPECT_NEAR(highest - lowest, 1.75 - 0.01, 1e-3);  // hips at 0.95 over toes at 0.01, and 0.8 above
}

}  // namespace
}  // namespace knuckle
