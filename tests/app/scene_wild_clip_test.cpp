#include <fmt/format.h>

#include "tests/app/one_object_scene.h"

namespace knuckle::test {

namespace {

/// Hips and legs that stand still for two seconds, except for a left knee, which first bends, and then beyond its toes
/// for three frames.
std::string kickedKnee()
{
    std::string text = R"(HIERARCHY
ROOT Hips
{
  OFFSET 0 1 0
  CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation
  JOINT LeftUpLeg
  {
    OFFSET 0.1 0 0
    CHANNELS 3 Zrotation Xrotation Yrotation
    JOINT LeftLeg
    {
      OFFSET 0 -0.45 0
      CHANNELS 3 Zrotation Xrotation Yrotation
      End Site
      {
        OFFSET 0 -0.45 0
      }
    }
  }
  JOINT RightUpLeg
  {
    OFFSET -0.1 0 0
    CHANNELS 3 Zrotation Xrotation Yrotation
    JOINT RightLeg
    {
      OFFSET 0 -0.45 0
      CHANNELS 3 Zrotation Xrotation Yrotation
      End Site
      {
        OFFSET 0 -0.45 0
      }
    }
  }
}
MOTION
Frames: 121
Frame Time: 0.0166667
)";
    for (int k = 0; k <= 120; ++k)
        text += fmt::format("0 1 0 0 0 0 0 0 0 0 {} 0 0 0 0 0 0 0\n", k < 40 ? 40 : k >= 60 && k < 63 ? -90 : 0);
    return text;
}

}  // namespace

TEST(SceneWildClip, AMomentOfAClipIsHeldAtTheLimitsAndTold)
{
    const TempFolder folder;
    const std::string clip = folder.write("kick.bvh", kickedKnee());
    const std::string scene = folder.write(
        "scene.json", fmt::format(R"({{"diameter": 0.05, "objects": [{{"type": "actor", "file": "{}",
                    "animation": {{"file": "{}", "loop": false}}}}]}})",
                                  inSource("assets/models/humanoid.glb"), clip));
    const Scene loaded = loadScene(scene, {});
    ASSERT_EQ(std::ranges::count_if(loaded.notes,
                                    [](const std::string& note) {
                                        return note.starts_with("/objects/0/animation: Clip 'Motion' turns joints "
                                                                "beyond what a body's do, for a moment or by far, "
                                                                "and is held at their limits: shin.L by ");
                                    }),
              1);
    const World& world = loaded.world;
    const auto knee = std::ranges::find(world.joints, "shin.L", &Joint::name);
    ASSERT_NE(knee, world.joints.end());
    EXPECT_GT(knee->limits.twist.lowest, -0.2f);
    float back = 0.0f;
    for (int k = 0; k < 240; ++k) {
        const std::vector<Pose> poses = bodyPlaces(world, world.animations[0], k / 120.0);
        const Quaternionf turn = (poses[knee->parent].rotation * knee->parentSide.frame).conjugate() *
                                 (poses[knee->child].rotation * knee->childSide.frame);
        back = std::min(back, 2 * std::atan2(turn.x(), turn.w()));
    }
    EXPECT_GT(back, knee->limits.twist.lowest + 0.04f) << "between keys, too";
}

}  // namespace knuckle::test
