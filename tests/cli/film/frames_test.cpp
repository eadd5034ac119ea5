#include <fmt/format.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>

#include "render/output/ffmpeg.h"
#include "render/picture/image.h"
#include "tests/cli/cli_fixture.h"

namespace knuckle {
namespace {

namespace fs = std::filesystem;
using test::RunResult;

/// Which frames are written, and under which names; of the tiny scene with ten frames.
class Frames : public test::CliTest {
protected:
    RunResult render(std::vector<std::string> more, test::RunOptions options = {}) const
    {
        more.insert(more.begin(), {"render", scene, "--set", "duration=0.166"});
        return run(more, std::move(options));
    }
    std::string text(const std::string& file) const { return test::readText(folder.path(file)); }
    std::vector<std::string> named(const std::string& where) const { return test::listFolder(folder.path(where)); }
    /// When a file was written last.
    fs::file_time_type written(const std::string& file) const { return fs::last_write_time(folder.path(file)); }
};

TEST_F(Frames, HaveTheNamesOfTheirPattern)
{
    ASSERT_EQ(render({"-o", "all", "--frames", "9:10"}).code, 0);
    ASSERT_EQ(render({"-o", "a/b_#_c.png", "-o", "a/d-#####.PNG", "-o", "a/e##.jpg", "--frames", "9:10"}).code, 0);
    EXPECT_EQ(named("a"), (std::vector<std::string>{"b_10_c.png", "b_9_c.png", "d-00009.PNG", "d-00010.PNG", "e09.jpg",
                                                    "e10.jpg"}));
    EXPECT_EQ(text("a/b_10_c.png"), text("all/frame_0010.png"));
    EXPECT_EQ(text("a/d-00009.PNG"), text("all/frame_0009.png"));
    ASSERT_EQ(render({"-o", "still.png", "--frames", "9"}).code, 0);
    EXPECT_EQ(text("still.png"), text("all/frame_0009.png"));
}

TEST_F(Frames, LastIsTheLastWhicheverItIs)
{
    ASSERT_EQ(render({"-o", "all", "--record", "states=r.states", "--record-every", "4"}).code, 0);
    ASSERT_EQ(render({"-o", "one", "--frames", "last", "--checkpoint", "0", "--resume"}).code, 0);
    EXPECT_EQ(named("one"), std::vector<std::string>{"frame_0010.png"});
    EXPECT_EQ(text("one/frame_0010.png"), text("all/frame_0010.png"));
    ASSERT_EQ(run({"render", "--from", "r.states", "-o", "still.png", "--frames", "last"}).code, 0);
    EXPECT_EQ(text("still.png"), text("all/frame_0010.png"));
    expectError(run({"render", scene, "--frames", "lats"}), 2,
                "--frames lats: must be A:B, frames from 1, for instance 1:60, or last");
}

TEST_F(Frames, AsJpegLookAsThoseOfPng)
{
    ASSERT_EQ(render({"-o", "f", "-o", "f/a_####.jpeg", "--frames", "4"}).code, 0);
    ASSERT_EQ(render({"-o", "f/low.jpg", "--frames", "4", "--quality", "10"}).code, 0);
    const Image png = readImage(folder.path("f/frame_0004.png"));
    const auto distance = [&](const std::string& file) {
        const Image jpeg = readImage(folder.path(file));
        EXPECT_EQ(jpeg.rgb.size(), png.rgb.size());
        double sum = 0.0;
        for (size_t i = 0; i < png.rgb.size(); ++i) sum += std::abs(jpeg.rgb[i] - png.rgb[i]);
        return sum / static_cast<double>(png.rgb.size());
    };
    // Of quality 92, coefficients of 8 x 8 pixels are rounded to steps of 2 to 19 shades (16 % of the standard's
    // table). Errors of a step / sqrt(12) in each, some 10 of them on average, are 3 shades a pixel where all are in
    // use.
    EXPECT_LT(distance("f/a_0004.jpeg"), 3.0);
    EXPECT_GT(distance("f/low.jpg"), 2.0 * distance("f/a_0004.jpeg"));
    EXPECT_LT(fs::file_size(folder.path("f/low.jpg")), fs::file_size(folder.path("f/a_0004.jpeg")));
    if (findProgram("ffprobe").empty()) GTEST_SKIP() << "ffmpeg is not installed";
    const std::string probe = "ffprobe -v error -show_entries stream=codec_name,width,height -of csv=p=0 ";
    ASSERT_EQ(std::system((probe + folder.path("f/a_0004.jpeg") + " > " + folder.path("said")).c_str()), 0);
    EXPECT_TRUE(text("said").starts_with("mjpeg,64,36")) << text("said");
}

TEST_F(Frames, ThatCannotBeNamedAreRefusedInOneLine)
{
    expectError(render({"-o", "a.png"}), 2,
                "-o a.png: names one picture, and there are 10 frames; name them a_####.png, or choose one by "
                "--frames");
    expectError(render({"-o", "a_##_##.png"}), 2,
                "-o a_##_##.png: has # at several places; give the frame's number one");
    expectError(render({"-o", "a/f_##.png", "-o", "./a/f_###.png"}), 2,
                folder.path("a") + " would be written twice; give each output a name of its own");
    EXPECT_EQ(render({"-o", "f_#.jpg", "--quality", "0"}).code, 2);
    folder.write("x_03.json", TINY_SCENE);
    fs::create_symlink("x_03.json", folder.path("x_03.png"));
    const RunResult over = run({"render", "x_03.json", "-o", "x_##.png"});
    EXPECT_EQ(over.code, 2);
    EXPECT_NE(over.err.find("would be written over x_03.json, which is read"), std::string::npos) << over.err;
    EXPECT_EQ(text("x_03.json"), TINY_SCENE);
}

TEST_F(Frames, OfAStrideAreThoseOfAFullRun)
{
    const bool films = !findProgram("ffprobe").empty();
    ASSERT_EQ(render({"-o", "all", "--export", "bodies=all.csv"}).code, 0);
    std::vector<std::string> words{"-o", "some", "--export", "bodies=some.csv", "--frames", "2:", "--stride", "3"};
    if (films) words.insert(words.end(), {"-o", "some.mp4"});
    const RunResult some = render(words);
    ASSERT_EQ(some.code, 0) << some.err;
    EXPECT_NE(some.out.find("10 frames, 3 of them drawn"), std::string::npos) << some.out;
    EXPECT_EQ(named("some"), (std::vector<std::string>{"frame_0002.png", "frame_0005.png", "frame_0008.png"}));
    for (const std::string& name : named("some")) EXPECT_EQ(text("some/" + name), text("all/" + name)) << name;
    // Exports have all frames from 2 on.
    const std::string rows = text("all.csv");
    EXPECT_TRUE(rows.ends_with(text("some.csv").substr(text("some.csv").find("\n2,") + 1)));
    if (!films) GTEST_SKIP() << "ffmpeg is not installed";
    const std::string probe = "ffprobe -v error -count_frames -show_entries stream=r_frame_rate,nb_read_frames "
                              "-of csv=p=0 ";
    ASSERT_EQ(std::system((probe + folder.path("some.mp4") + " > " + folder.path("said")).c_str()), 0);
    EXPECT_TRUE(text("said").starts_with("20/1,3")) << text("said");
}

TEST_F(Frames, OfAStrideGoOnFromACheckpoint)
{
    const std::vector<std::string> words{"-q", "-o", "some", "-o", "b_##.jpg", "--stride", "3", "--checkpoint", "0"};
    ASSERT_EQ(render(words).code, 0);
    const auto before = written("some/frame_0004.png");
    std::vector<std::string> more = words;
    more.push_back("--resume");
    fs::remove(folder.path("b_07.jpg"));
    const RunResult again = render(more);
    ASSERT_EQ(again.code, 0) << again.err;
    EXPECT_TRUE(fs::exists(folder.path("b_07.jpg")));
    EXPECT_EQ(written("some/frame_0004.png"), before);
    more[more.size() - 4] = "2";
    EXPECT_NE(render(more).err.find("was left by a run with other outputs, "), std::string::npos);
}

TEST_F(Frames, OfStoredStatesHaveAStrideToo)
{
    ASSERT_EQ(render({"-o", "all", "--record", "states=r.states"}).code, 0);
    ASSERT_EQ(run({"-q", "render", "--from", "r.states", "-o", "again", "--stride", "4"}).code, 0);
    EXPECT_EQ(named("again"), (std::vector<std::string>{"frame_0001.png", "frame_0005.png", "frame_0009.png"}));
    EXPECT_EQ(readImage(folder.path("again/frame_0005.png")).rgb, readImage(folder.path("all/frame_0005.png")).rgb);
}

TEST_F(Frames, ThatAreThereAndWholeAreSkipped)
{
    ASSERT_EQ(render({"-o", "f"}).code, 0);
    const std::string third = text("f/frame_0003.png"), fifth = text("f/frame_0005.png");
    std::string damaged = fifth;
    damaged[damaged.size() / 2] = static_cast<char>(damaged[damaged.size() / 2] ^ 1);
    folder.write("f/frame_0005.png", damaged);
    folder.write("f/frame_0003.png", third.substr(0, third.size() - 5));
    const auto before = written("f/frame_0002.png"), last = written("f/frame_0010.png");
    const RunResult some = render({"-o", "f", "--skip-existing"});
    ASSERT_EQ(some.code, 0) << some.err;
    EXPECT_NE(some.out.find("5 frames, 2 of them drawn"), std::string::npos) << some.out;
    EXPECT_EQ(text("f/frame_0003.png"), third);
    EXPECT_EQ(text("f/frame_0005.png"), fifth);
    EXPECT_EQ(written("f/frame_0002.png"), before);
    EXPECT_EQ(written("f/frame_0010.png"), last);
    // Of another size they are not what is wanted.
    EXPECT_NE(render({"-o", "f", "--skip-existing", "--size", "32x18"}).out.find("10 frames, 10 of them"),
              std::string::npos);
    EXPECT_EQ(readImage(folder.path("f/frame_0010.png")).width, 32u);
}

/// No device is opened: the one asked for is not there.
TEST_F(Frames, ThatAreAllThereNeedNoSimulation)
{
    ASSERT_EQ(render({"-o", "f", "-o", "g_##.jpg", "--stride", "2"}).code, 0);
    const std::vector<std::string> words{"render", scene,      "--set",    "duration=0.166",  "-o",
                                         "f",      "-o",       "g_##.jpg", "--skip-existing", "--stride",
                                         "2",      "--device", "99"};
    const test::RunOptions options{.folder = folder.path()};
    const RunResult all = test::runKnuckle(words, options);
    EXPECT_EQ(all.code, 0) << all.err;
    EXPECT_EQ(all.out, "5 frames, and all are there: f, g_##.jpg\n");
    EXPECT_EQ(all.err, "");
    fs::remove(folder.path("g_05.jpg"));
    EXPECT_NE(test::runKnuckle(words, options).code, 0) << "a device is needed again";
    // What else is wanted of the run needs it, too.
    const RunResult hash = render({"-o", "f", "--stride", "2", "--skip-existing", "--hash"});
    EXPECT_NE(hash.out.find("10 frames, 0 of them drawn"), std::string::npos) << hash.out;
    EXPECT_NE(hash.out.find("state hash "), std::string::npos) << hash.out;
}

TEST_F(Frames, ThatAreSkippedCountAsDoneForACheckpoint)
{
    ASSERT_EQ(render({"-o", "f"}).code, 0);
    fs::remove(folder.path("f/frame_0008.png"));
    fs::remove(folder.path("f/frame_0009.png"));
    const auto before = written("f/frame_0002.png");
    const std::vector<std::string> words{"-o", "f", "--skip-existing", "--checkpoint", "0", "--resume"};
    render(words, {.signalAfterFile = SIGKILL, .waitFor = folder.path("f/frame_0008.png")});
    std::vector<std::string> rest{"-o", "f", "--checkpoint", "0", "--resume"};
    const RunResult end = render(rest);
    ASSERT_EQ(end.code, 0) << end.err;
    EXPECT_NE(end.err.find("note: goes on after frame "), std::string::npos) << end.err;
    EXPECT_EQ(named("f").size(), 10u);
    EXPECT_EQ(written("f/frame_0002.png"), before);
}

}  // namespace
}  // namespace knuckle
