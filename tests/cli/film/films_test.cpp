#include <csignal>
#include <filesystem>

#include "render/output/ffmpeg.h"
#include "render/picture/image.h"
#include "tests/cli/cli_fixture.h"

namespace knuckle {
namespace {

namespace fs = std::filesystem;
using test::RunResult;

/// What `-o`, `--codec` and `--pipe` make of the tiny scene: four frames of 64 x 36.
class Films : public test::CliTest {
protected:
    std::string pixels() const
    {
        std::string bytes;
        for (int frame = 1; frame <= 4; ++frame) {
            const Image image = readImage(folder.path("out/frame_000" + std::to_string(frame) + ".png"));
            bytes.append(image.rgb.begin(), image.rgb.end());
        }
        return bytes;
    }
};

TEST_F(Films, IntoAPipeMayBeTheBareFrames)
{
    const RunResult raw = run({"-q", "render", scene, "-o", "out", "-o", "-", "--pipe", "raw"},
                              {.environment = {"PATH=/nowhere"}});
    ASSERT_EQ(raw.code, 0) << raw.err;
    EXPECT_TRUE(raw.out == pixels()) << raw.out.size() << " bytes";
    if (findProgram("ffmpeg").empty()) GTEST_SKIP() << "ffmpeg is not installed";
    const RunResult y4m = run({"-q", "render", scene, "-o", "-", "--pipe", "y4m"});
    ASSERT_EQ(y4m.code, 0) << y4m.err;
    EXPECT_TRUE(y4m.out.starts_with("YUV4MPEG2 W64 H36 F60:1 ")) << y4m.out.substr(0, 80);
    const size_t head = y4m.out.find('\n') + 1;
    EXPECT_EQ(y4m.out.size(), head + 4 * (std::string("FRAME\n").size() + 64 * 36 * 3 / 2));
    const RunResult webm = run({"-q", "render", scene, "-o", "-", "--pipe", "webm"});
    EXPECT_EQ(webm.out.substr(0, 4), "\x1a\x45\xdf\xa3") << webm.err;
}

TEST_F(Films, OfSeveralKindsComeOfOneRun)
{
    if (findProgram("ffmpeg").empty()) GTEST_SKIP() << "ffmpeg is not installed";
    ASSERT_EQ(run({"-q", "render", scene, "-o", "a.mp4", "-o", "b.GIF", "-o", "c.webp", "-o", "d.apng", "-o", "e.webm",
                   "-o", "frames", "--codec", "av1"})
                  .code,
              0);
    EXPECT_NE(test::readText(folder.path("a.mp4")).find("av01"), std::string::npos);
    EXPECT_TRUE(test::readText(folder.path("b.GIF")).starts_with("GIF89a"));
    EXPECT_EQ(test::readText(folder.path("c.webp")).substr(8, 4), "WEBP");
    EXPECT_NE(test::readText(folder.path("d.apng")).find("acTL"), std::string::npos);
    EXPECT_NE(test::readText(folder.path("e.webm")).find("V_AV1"), std::string::npos);
    EXPECT_EQ(madeFiles().size(), 6u + 4u) << "and nothing temporary";
}

TEST_F(Films, AskedForInVainAreRefusedInOneLine)
{
    const struct {
        std::vector<std::string> words;
        const char* message;
    } cases[] = {
        {{"-o", "a.mp4", "--codec", "mpeg2"}, "--codec mpeg2: must be h264, h265, av1 or vp9"},
        {{"-o", "out", "-o", "a.gif", "--codec", "av1"},
         "--codec av1: no output is a film that has a codec to choose; name one .mp4, .mov, .mkv or .webm"},
        {{"-o", "-", "--pipe", "raw", "--codec", "av1"},
         "--codec av1: no output is a film that has a codec to choose; name one .mp4, .mov, .mkv or .webm"},
        {{"-o", "-", "--pipe", "gif"}, "--pipe gif: must be mp4, mkv, webm, y4m or raw"},
        {{"-o", "a.mp4", "--pipe", "raw"}, "--pipe raw: no output is a stream; add -o -"},
    };
    for (const auto& entry : cases) {
        std::vector<std::string> words{"render", scene};
        words.insert(words.end(), entry.words.begin(), entry.words.end());
        expectError(run(words), 2, entry.message);
    }
    if (!findProgram("ffmpeg").empty())
        expectError(run({"render", scene, "-o", "a.webm", "--codec", "h264"}), 2,
                    "film a.webm: a .webm has no h264; choose --codec vp9 or av1, or another ending");
    EXPECT_TRUE(madeFiles().empty());
}

/// Of each kind, what is joined at the end is the same, however often the run was ended.
TEST_F(Films, GoOnFromACheckpointWithTheSameBytes)
{
    if (findProgram("ffmpeg").empty()) GTEST_SKIP() << "ffmpeg is not installed";
    const std::vector<std::string> words{"-q",        "render", scene,        "--set", "duration=0.4", "-o",
                                         "out/a.gif", "-o",     "out/b.webm", "-o",    "out/c.apng"};
    ASSERT_EQ(run(words).code, 0);
    std::vector<std::string> wanted;
    for (const char* name : {"out/a.gif", "out/b.webm", "out/c.apng"})
        wanted.push_back(test::readText(folder.path(name)));
    fs::remove_all(folder.path("out"));
    std::vector<std::string> kept = words;
    kept.insert(kept.end(), {"--checkpoint", "0", "--resume"});
    const RunResult ended = run(
        kept, {.signalAfterFile = SIGKILL, .waitFor = folder.path("out/a.gif.checkpoint/film_2/frame_000009")});
    EXPECT_NE(ended.code, 0);
    EXPECT_FALSE(fs::exists(folder.path("out/a.gif")));
    ASSERT_EQ(run(kept).code, 0);
    size_t k = 0;
    for (const char* name : {"out/a.gif", "out/b.webm", "out/c.apng"})
        EXPECT_TRUE(test::readText(folder.path(name)) == wanted[k++]) << name;
    kept.insert(kept.end(), {"--codec", "av1"});
    EXPECT_NE(run(kept).err.find("was left by a run with other outputs"), std::string::npos);
}

}  // namespace
}  // namespace knuckle
