#include "render/output/frame_sink.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "render/output/ffmpeg.h"
#include "render/output/film_segments.h"
#include "sim/base/errors.h"
#include "tests/temp_folder.h"

namespace knuckle::test {
namespace {

namespace fs = std::filesystem;

class FrameSinkTest : public testing::Test {
protected:
    FrameSinkTest()
    {
        std::string name = (fs::temp_directory_path() / "knuckle_sink_XXXXXX").string();
        folder_ = mkdtemp(name.data());
    }
    ~FrameSinkTest() override { fs::remove_all(folder_); }

    std::string at(const std::string& name) const { return (folder_ / name).string(); }
    /// Hidden ones included.
    size_t fileCount() const { return static_cast<size_t>(std::distance(fs::directory_iterator(folder_), {})); }

    fs::path folder_;
};

/// Noise, so that deflate cannot compress it.
Image noise(uint32_t width, uint32_t height, uint32_t seed = 1)
{
    Image image{width, height, std::vector<uint8_t>(size_t{3} * width * height)};
    for (uint8_t& channel : image.rgb) {
        seed = seed * 1664525u + 1013904223u;
        channel = static_cast<uint8_t>(seed >> 24);
    }
    return image;
}

/// Runs `work` in a child whose files may not grow beyond `bytes`, as on a full disk. @returns its exit code.
template <typename Work>
int onFullDisk(rlim_t bytes, Work work)
{
    const pid_t child = fork();
    if (child == 0) {
        const rlimit limit{bytes, bytes};
        setrlimit(RLIMIT_FSIZE, &limit);
        std::signal(SIGXFSZ, SIG_IGN);
        int code = 0;
        try {
            work();
        } catch (const RunError&) {
            code = 1;
        } catch (...) {
            code = 9;
        }
        _exit(code);
    }
    int status = 0;
    waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST_F(FrameSinkTest, PngRoundTripKeepsEveryPixel)
{
    const Image image = noise(37, 21);
    writePng(at("a.png"), image);
    const Image back = readImage(at("a.png"));
    EXPECT_EQ(back.width, 37u);
    EXPECT_EQ(back.height, 21u);
    EXPECT_EQ(back.rgb, image.rgb);
    EXPECT_EQ(fileCount(), 1u);
}

TEST_F(FrameSinkTest, ReadingNamesWhatIsWrong)
{
    EXPECT_THROW(readImage(at("missing.png")), InputError);
    std::ofstream(at("text.png")) << "not an image";
    EXPECT_THROW(readImage(at("text.png")), InputError);
    EXPECT_THROW(readImage(folder_.string()), InputError);
}

TEST_F(FrameSinkTest, FramesAreNumberedAndComplete)
{
    const auto sink = pictureSink(FrameNames::of(at("deep/frames")));
    for (uint64_t i = 1; i <= 7; ++i) sink->write(noise(16, 16, static_cast<uint32_t>(i)), i);
    sink->finish();
    EXPECT_EQ(readImage(at("deep/frames/frame_0001.png")).rgb, noise(16, 16, 1).rgb);
    EXPECT_EQ(readImage(at("deep/frames/frame_0007.png")).rgb, noise(16, 16, 7).rgb);
    EXPECT_EQ(std::distance(fs::directory_iterator(at("deep/frames")), {}), 7);
}

TEST_F(FrameSinkTest, AFolderThatCannotBeMadeIsAnInputError)
{
    std::ofstream(at("file")) << "x";
    EXPECT_THROW(pictureSink(FrameNames::of(at("file/frames"))), InputError);
    EXPECT_THROW(pictureSink(FrameNames::of("/proc/frames")), InputError);
    EXPECT_THROW(filmSink(at("file/film.mp4"), {16, 16, 30}), InputError);
}

TEST_F(FrameSinkTest, AFullDiskIsARunErrorAndLeavesNoHalfWrittenFrame)
{
    EXPECT_EQ(onFullDisk(1000, [&] { writePng(at("a.png"), noise(64, 64)); }), 1);
    EXPECT_EQ(onFullDisk(1000,
                         [&] {
                             const auto sink = pictureSink(FrameNames::of(folder_.string()));
                             sink->write(noise(64, 64), 1);
                             sink->finish();
                         }),
              1);
    EXPECT_EQ(fileCount(), 0u);
}

TEST_F(FrameSinkTest, AFilmAppearsWholeAndAtItsSize)
{
    if (findProgram("ffmpeg").empty()) GTEST_SKIP() << "ffmpeg is not installed";
    const auto sink = filmSink(at("film.mp4"), {33, 21, 30.0});
    for (uint64_t i = 1; i <= 5; ++i) sink->write(noise(33, 21, static_cast<uint32_t>(i)), i);
    EXPECT_FALSE(fs::exists(at("film.mp4")));
    sink->finish();
    EXPECT_GT(fs::file_size(at("film.mp4")), 500u);
    EXPECT_EQ(fileCount(), 1u);
}

TEST_F(FrameSinkTest, AFilmOfSeveralSegmentsHasAllFramesAtTheirTimes)
{
    if (findProgram("ffprobe").empty()) GTEST_SKIP() << "ffmpeg is not installed";
    constexpr uint64_t FRAMES = 2 * SEGMENT_FRAMES + 7;
    // Matroska counts milliseconds, a GIF hundredths, and readers of APNG hundred thousandths from frame to frame.
    const struct {
        std::string film;
        double tolerance;  ///< [s]
    } films[] = {{"film.mp4", 0.0001},  {"film.mov", 0.0001}, {"film.mkv", 0.0006},
                 {"film.webm", 0.0006}, {"film.gif", 0.0051}, {"film.apng", 1e-5 * FRAMES}};
    for (const auto& [film, tolerance] : films) {
        std::string first;
        for (int round = 0; round < 2; ++round) {
            const auto sink = filmSink(at(film), {16, 16, 7.0});
            for (uint64_t i = 1; i <= FRAMES; ++i) sink->write(noise(16, 16, static_cast<uint32_t>(i)), i);
            sink->finish();
            if (round == 0) first = readText(at(film));
        }
        EXPECT_TRUE(readText(at(film)) == first) << "other bytes the second time";
        const std::string command = "ffprobe -loglevel error -show_entries frame=pts_time -of csv=p=0 " + at(film) +
                                    " | tr -d , > " + at("times");
        ASSERT_EQ(std::system(command.c_str()), 0);
        std::ifstream times(at("times"));
        uint64_t count = 0;
        for (double time; times >> time; ++count)
            EXPECT_NEAR(time, static_cast<double>(count) / 7.0, tolerance) << film;
        EXPECT_EQ(count, FRAMES) << film;
    }
}

TEST_F(FrameSinkTest, AnAbandonedFilmLeavesNothing)
{
    if (findProgram("ffmpeg").empty()) GTEST_SKIP() << "ffmpeg is not installed";
    {
        const auto sink = filmSink(at("film.mp4"), {32, 32, 30.0});
        sink->write(noise(32, 32), 1);
        EXPECT_THROW(sink->write(noise(16, 16), 2), RunError);
    }
    EXPECT_EQ(fileCount(), 0u);
}

TEST_F(FrameSinkTest, AFullDiskStopsAFilmWithOneLine)
{
    if (findProgram("ffmpeg").empty()) GTEST_SKIP() << "ffmpeg is not installed";
    EXPECT_EQ(onFullDisk(20000,
                         [&] {
                             const auto sink = filmSink(at("film.mp4"), {256, 256, 30.0});
                             for (uint64_t i = 1; i <= 40; ++i)
                                 sink->write(noise(256, 256, static_cast<uint32_t>(i)), i);
                             sink->finish();
                         }),
              1);
    EXPECT_EQ(fileCount(), 0u);
}

/// Replaces PATH until it is destroyed.
class PathIs {
public:
    explicit PathIs(const std::string& path) : before_(std::getenv("PATH")) { setenv("PATH", path.c_str(), 1); }
    ~PathIs() { setenv("PATH", before_.c_str(), 1); }

private:
    std::string before_;
};

TEST_F(FrameSinkTest, WithoutFfmpegAFilmIsAnInputErrorThatSaysWhatToInstall)
{
    const PathIs path(folder_.string());
    try {
        filmSink(at("film.mp4"), {32, 32, 30.0});
        FAIL() << "made a film without ffmpeg";
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("ffmpeg"), std::string::npos);
    }
    EXPECT_EQ(fileCount(), 0u);
}

TEST_F(FrameSinkTest, WhatFfmpegSaysReachesTheUserInOneLine)
{
    fs::create_directory(at("bin"));
    // What is tried before the first frame goes well.
    std::ofstream(at("bin/ffmpeg")) << "#!/bin/sh\ncase $* in *lavfi*) exit 0;; esac\n"
                                       "echo 'the encoder is broken' >&2\necho 'really' >&2\nexit 3\n";
    fs::permissions(at("bin/ffmpeg"), fs::perms::owner_all);
    const PathIs path(at("bin"));
    const auto sink = filmSink(at("film.mp4"), {512, 512, 30.0});
    try {
        // More than a pipe holds, so that a write fails after the reader has closed.
        for (uint64_t i = 1; i <= 8; ++i) sink->write(noise(512, 512), i);
        sink->finish();
        FAIL() << "a failing ffmpeg went unnoticed";
    } catch (const RunError& error) {
        EXPECT_NE(std::string(error.what()).find("the encoder is broken; really"), std::string::npos) << error.what();
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    }
}

TEST_F(FrameSinkTest, AFilmOfUnknownKindIsRefused)
{
    EXPECT_THROW(filmSink(at("film.avi"), {32, 32, 30.0}), InputError);
}

}  // namespace
}  // namespace knuckle::test
