#include <gtest/gtest.h>

#include "tests/rig/anatomy/rigs.h"

namespace knuckle::test {

using Eigen::Vector3f;

TEST(Anatomy, OddSkeletonsAreRead)
{
    EXPECT_TRUE(readAnatomy({}).empty());
    Rig one;
    one.add("leg.L", -1, {0, 0, 0});
    EXPECT_EQ(readAnatomy(one.model).front().owner, 0u);
    for (const char* name : {"node", "leg", "arm.L", "LeftShoulder", "twist", "hair", "thigh.L", "ik"}) {
        Rig chain;
        for (int i = 0; i < 1000; ++i) chain.add(name, i - 1, {0.0f, 0.0f, 0.01f * float(i)});
        const std::vector<BoneAnatomy> anatomy = readAnatomy(chain.model);
        for (const BoneAnatomy& bone : anatomy) ASSERT_LT(bone.owner, anatomy.size()) << name;
    }
    Rig star;
    star.add("node", -1, {0, 0, 0});
    for (int i = 0; i < 1000; ++i) star.add("hand.L", 0, {float(i % 7), float(i % 5), float(i % 3)});
    EXPECT_EQ(readAnatomy(star.model)[5].owner, 1u);
}

TEST(Anatomy, ABoneThatClipsTurnAboutOneAxisIsAHinge)
{
    Rig rig;
    rig.add("base", -1, {0, 0, 0});
    rig.add("lid", 0, {0, 1, 0});
    rig.add("ball joint", 0, {0, 2, 0});
    Clip clip{"open", 1.0, {}, {}};
    for (int key = 0; key < 5; ++key) {
        std::vector<Eigen::Matrix4f> poses;
        for (const Bone& bone : rig.model.bones) poses.push_back(bone.restPose);
        const float angle = 0.3f * float(key);
        poses[1].topLeftCorner<3, 3>() = Eigen::AngleAxisf(angle, Vector3f(0, 0.6f, 0.8f)).toRotationMatrix();
        poses[2].topLeftCorner<3, 3>() =
            Eigen::AngleAxisf(angle, Vector3f(1, angle, 0).normalized()).toRotationMatrix();
        clip.keyTimes.push_back(0.25 * key);
        clip.poses.push_back(poses);
    }
    rig.model.clips.push_back(clip);
    rig.model.bones[1].name = "door";
    const std::vector<BoneAnatomy> anatomy = readAnatomy(rig.model);
    EXPECT_EQ(anatomy[1].source, AnatomySource::Clip);
    EXPECT_LT((anatomy[1].axis - Vector3f(0, 0.6f, 0.8f)).norm(), 1e-4f);
    EXPECT_EQ(anatomy[2].source, AnatomySource::None);
}

}  // namespace knuckle::test
