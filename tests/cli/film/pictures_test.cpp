#include <algorithm>

#include "render/picture/image.h"
#include "render/reader/picture_file.h"
#include "tests/cli/cli_fixture.h"

namespace knuckle {
namespace {

using test::RunResult;

/// What is written over pictures, their formats, and several scenes in a call.
class Pictures : public test::CliTest {
protected:
    Picture read(const std::string& name) const { return readPicture(folder.path(name)); }
};

TEST_F(Pictures, GetCaptionsAndLabels)
{
    ASSERT_EQ(run({"-q", "render", scene, "-o", "plain"}).code, 0);
    ASSERT_EQ(run({"-q", "render", scene, "-o", "said", "--caption", "Ä b", "--labels", "frame,time,scaleBar"}).code,
              0);
    ASSERT_EQ(
        run({"-q", "render", scene, "-o", "now", "--set", R"(captions=[{"text": "now", "from": 0.016, "to": 0.033}])"})
            .code,
        0);
    for (const std::string frame : {"/frame_0001.png", "/frame_0002.png", "/frame_0003.png", "/frame_0004.png"}) {
        const Image plain = readImage(folder.path("plain" + frame));
        EXPECT_NE(readImage(folder.path("said" + frame)).rgb, plain.rgb);
        EXPECT_EQ(readImage(folder.path("now" + frame)).rgb != plain.rgb, frame == "/frame_0002.png") << frame;
    }
}

TEST_F(Pictures, HaveSixteenBitsOrLinearLight)
{
    ASSERT_EQ(run({"-q", "render", scene, "-o", "deep", "-o", "e_##.exr", "--depth", "16"}).code, 0);
    ASSERT_EQ(run({"-q", "render", scene, "-o", "plain", "-o", "f_##.exr"}).code, 0);
    const Picture deep = read("deep/frame_0003.png"), plain = read("plain/frame_0003.png"), exr = read("e_03.exr");
    EXPECT_EQ(deep.bitDepth, 16u);
    EXPECT_EQ(plain.bitDepth, 8u);
    for (size_t k = 0; k < deep.rgba.size(); ++k) {
        EXPECT_NEAR(deep.rgba[k], plain.rgba[k], 0.51 / 255.0);
        EXPECT_NEAR(deep.rgba[k], exr.rgba[k], 1e-3);
    }
    EXPECT_EQ(run({"compare", "e_03.exr", "f_03.exr"}).code, 0);
    expectError(run({"render", scene, "--depth", "12"}), 2, "--depth 12: must be 8 or 16");
}

TEST_F(Pictures, OfSeveralScenesAreInFoldersOfTheirOwn)
{
    folder.write("other.json", TINY_SCENE);
    ASSERT_EQ(run({"-q", "render", scene, "other.json", "-o", "all"}).code, 0);
    EXPECT_EQ(readImage(folder.path("all/tiny/frame_0004.png")).rgb,
              readImage(folder.path("all/other/frame_0004.png")).rgb);
    // What fails does not keep the next one back.
    const RunResult mixed = run({"-q", "render", "none.json", "other.json"});
    EXPECT_EQ(mixed.code, 2);
    EXPECT_EQ(std::count(mixed.err.begin(), mixed.err.end(), '\n'), 1) << mixed.err;
    EXPECT_EQ(readImage(folder.path("out/other/frame_0001.png")).width, 64u);
    expectError(run({"render", scene, "other.json", "-o", "a.mp4"}), 2,
                "-o a.mp4: several scenes want a folder, in which each gets one of its own");
    folder.write("named.json", std::string("{ \"name\": \"other\",") + (TINY_SCENE + 1));
    expectError(run({"-q", "render", "other.json", "named.json"}), 2,
                "named.json: goes into out/other, as another one of the scenes; give it another \"name\"");
    expectError(run({"render", scene, scene}), 2, scene + ": is given twice; name each scene once");
    EXPECT_EQ(run({"render", scene, "other.json", "--stats", "s.json"}).code, 2);
}

TEST_F(Pictures, MistakesAreToldInOneLine)
{
    expectError(run({"render", scene, "--labels", "frame,tme"}), 2,
                scene + ": /render/labels/1: \"tme\" is unknown; did you mean \"time\"?");
    expectError(run({"render", scene, "--labels", "colorBar"}), 2,
                scene + ": /render/labels: \"colorBar\" needs a render.colorBy that shows a number, as \"speed\"");
    expectError(run({"render", scene, "--set", "render.colorBy=contactForce", "--set", "solver=paper"}), 2,
                scene + ": /render/colorBy: the paper's solver moves particles and has no forces of contacts; choose "
                        "another, or the solver \"default\"");
    expectError(run({"render", scene, "--set", "render.colorScale=[2, 1]"}), 2,
                scene + ": /render/colorScale: its high end must be above its low one");
    expectError(run({"render", scene, "--set", R"(captions=[{"text": "x", "from": 2, "to": 1}])"}), 2,
                scene + ": /captions/0/to: must be after `from`");
}

}  // namespace
}  // namespace knuckle
