#include <fmt/format.h>

#include "tests/app/one_object_scene.h"
#include "tests/temp_folder.h"

namespace knuckle::test {

namespace {

/// A hip and a leg that stand still for some frames of the given length. @param turn of the hip in each [degrees].
std::string motion(size_t frames, double seconds, const std::string& turn = "0")
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
    End Site
    {
      OFFSET 0 -0.45 0
    }
  }
}
MOTION
)";
    text += fmt::format("Frames: {}\nFrame Time: {}\n", frames, seconds);
    for (size_t k = 0; k < frames; ++k) text += fmt::format("0 1 0 0 {} 0 10 0 0\n", turn);
    return text;
}

}  // namespace

TEST(SceneClipErrors, AClipThatCannotBePlayedIsToldWithTheReason)
{
    const struct {
        std::string file, complaint;
    } cases[] = {
        {motion(1, 0.01), "has no length; give another, or take it as `pose`"},
        {motion(5, 0.01, "nan"), "has keys that are not numbers; export another"},
        {motion(5000, 1), "lasts 4999 s, more than 3600; export another"},
        {motion(1000000, 0.001), "has 1000000 keys of one bone, more than 500000; export another"},
    };
    const TempFolder folder;
    const std::string path = folder.path("moves.bvh");
    const auto figure = [&](const std::string& fields) {
        return R"({"type": "actor", "file": "FILE", )" + fmt::format(fmt::runtime(fields), path) + "}";
    };
    for (const auto& wrong : cases) {
        folder.write("moves.bvh", wrong.file);
        EXPECT_EQ(complaintOf(figure(R"("animation": {{"file": "{}"}})")),
                  "/objects/0/animation/clip: clip \"Motion\" " + wrong.complaint);
    }
    folder.write("moves.bvh", motion(1, 0.01));
    EXPECT_EQ(worldOf(figure(R"("pose": {{"file": "{}"}})")).animations.size(), 1u);
}

}  // namespace knuckle::test
