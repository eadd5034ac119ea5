#include "render/output/film_kinds.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "render/output/ffmpeg.h"
#include "render/output/frame_sink.h"
#include "sim/base/errors.h"
#include "tests/message_of.h"
#include "tests/temp_folder.h"

namespace knuckle::test {
namespace {

namespace fs = std::filesystem;

constexpr uint32_t WIDTH = 97, HEIGHT = 65;  // odd, and not less than any encoder takes
constexpr uint64_t FRAMES = 5;

/// A slow gradient with a box that moves.
Image picture(uint64_t number)
{
    Image image{WIDTH, HEIGHT, {}};
    for (uint32_t y = 0; y < HEIGHT; ++y)
        for (uint32_t x = 0; x < WIDTH; ++x) {
            const bool box = x / 16 == number % 6 && y / 16 == 1;
            const auto shade = static_cast<uint8_t>(60 + x);
            image.rgb.insert(image.rgb.end(), {box ? uint8_t{200} : shade, shade, box ? uint8_t{40} : uint8_t{120}});
        }
    return image;
}

class FilmKinds : public testing::Test {
protected:
    void SetUp() override
    {
        if (findProgram("ffprobe").empty()) GTEST_SKIP() << "ffmpeg is not installed";
    }
    /// Makes a film of FRAMES frames. @returns its path.
    std::string make(const std::string& name, const std::string& codec = "", double rate = 25.0) const
    {
        const auto sink = filmSink(folder_.path(name), {WIDTH, HEIGHT, rate, codec});
        for (uint64_t i = 1; i <= FRAMES; ++i) sink->write(picture(i), i);
        sink->finish();
        EXPECT_EQ(listed(), 1u) << "nothing but the film";
        return folder_.path(name);
    }
    size_t listed() const { return static_cast<size_t>(std::distance(fs::directory_iterator(folder_.path()), {})); }
    /// What a program prints of a file.
    std::string ask(const std::string& command) const
    {
        const std::string answer = other_.path("answer");
        EXPECT_EQ(std::system((command + " > " + answer).c_str()), 0) << command;
        return readText(answer);
    }
    std::string probe(const std::string& film) const
    {
        return ask("ffprobe -v error -count_frames -select_streams v -show_entries "
                   "stream=codec_name,width,height,nb_read_frames -of csv=p=0 " +
                   film);
    }
    /// Root of the mean squared difference of the first frame from what was given [shades of 255].
    double distance(const std::string& film) const
    {
        ask(fmt::format("ffmpeg -v error -y -i {} -frames:v 1 {}", film, other_.path("first.png")));
        const Image first = readImage(other_.path("first.png")), wanted = picture(1);
        double sum = 0.0;
        for (uint32_t y = 0; y < HEIGHT; ++y)
            for (uint32_t x = 0; x < 3 * WIDTH; ++x)
                sum += std::pow(first.rgb[y * 3 * first.width + x] - wanted.rgb[y * 3 * WIDTH + x], 2);
        return std::sqrt(sum / (3 * WIDTH * HEIGHT));
    }

    TempFolder folder_, other_;
};

TEST_F(FilmKinds, AreReadByAnotherProgramWithAllFramesAndColours)
{
    // Chroma at half the resolution blurs the edges of the box: where it ends within a block of 2x2 pixels, a row of
    // these is off by half of 140 shades of blue, 32 of 6305 pixels. The palette of a GIF has 256 of some 100 shades.
    constexpr double CHROMA = 7.0, PALETTE = 7.0;
    const struct {
        std::string name, codec, said;
        double tolerance;
    } films[] = {{"a.mp4", "", "h264,98,66,5", CHROMA},     {"a.mov", "h265", "hevc,98,66,5", CHROMA},
                 {"a.mp4", "h265", "hevc,98,66,5", CHROMA}, {"a.mkv", "av1", "av1,98,66,5", CHROMA},
                 {"a.mp4", "av1", "av1,98,66,5", CHROMA},   {"a.webm", "", "vp9,98,66,5", CHROMA},
                 {"a.gif", "", "gif,97,65,5", PALETTE},     {"a.apng", "", "apng,97,65,5", 0.0}};
    for (const auto& [name, codec, said, tolerance] : films) {
        const std::string film = make(name, codec);
        EXPECT_TRUE(probe(film).starts_with(said)) << name << " " << codec << ": " << probe(film);
        EXPECT_LE(distance(film), tolerance) << name << " " << codec;
        fs::remove(film);
    }
}

/// The number in four bytes of a RIFF file.
uint32_t numberAt(const std::string& bytes, size_t at)
{
    uint32_t number = 0;
    for (size_t k = 4; k-- > 0;) number = number << 8 | static_cast<uint8_t>(bytes.at(at + k));
    return number;
}

/// ffmpeg writes animations of WebP and does not read them: their first frame is cut out.
TEST_F(FilmKinds, OfWebPHaveAllFramesAndColours)
{
    const std::string bytes = readText(make("a.webp"));
    uint64_t frames = 0;
    std::string first;
    uint32_t milliseconds = 0;
    for (size_t at = 12, size = 0; at + 8 <= bytes.size(); at += 8 + size + size % 2) {
        size = numberAt(bytes, at + 4);
        if (bytes.substr(at, 4) != "ANMF") continue;
        milliseconds += numberAt(bytes, at + 8 + 12) & 0xffffff;
        if (frames++ == 0) first = bytes.substr(at + 8 + 16, size - 16);
    }
    EXPECT_EQ(frames, FRAMES);
    EXPECT_EQ(milliseconds, 1000 * FRAMES / 25);
    const auto size = static_cast<uint32_t>(first.size() + 4);
    const std::string head{static_cast<char>(size), static_cast<char>(size >> 8), static_cast<char>(size >> 16), 0};
    std::ofstream(other_.path("first.webp"), std::ios::binary) << "RIFF" + head + "WEBP" + first;
    EXPECT_LE(distance(other_.path("first.webp")), 7.0);  // as above
}

TEST_F(FilmKinds, OfGifsHaveNoMoreFramesThanBrowsersShow)
{
    // 5 frames in 1/12 s: 4 hundredths of 2 frames each, and one that begins.
    EXPECT_TRUE(probe(make("a.gif", "", 60.0)).starts_with("gif,97,65,4"));
}

/// A folder with an ffmpeg that lacks an encoder, as PATH.
class WithoutEncoder {
public:
    WithoutEncoder(const TempFolder& folder, const std::string& encoder) : before_(std::getenv("PATH"))
    {
        const std::string program = folder.path("ffmpeg"), real = findProgram("ffmpeg");
        std::ofstream(program) << fmt::format("#!/bin/sh\ncase \"$*\" in *{0}*) echo \"Unknown encoder '{0}'\" >&2; "
                                              "exit 1;; esac\nexec {1} \"$@\"\n",
                                              encoder, real);
        fs::permissions(program, fs::perms::owner_all);
        setenv("PATH", (folder.path() + ":" + before_).c_str(), 1);
    }
    ~WithoutEncoder() { setenv("PATH", before_.c_str(), 1); }

private:
    std::string before_;
};

TEST_F(FilmKinds, WhoseEncoderIsMissingAreRefusedBeforeAnyFrame)
{
    const WithoutEncoder without(other_, "libx265");
    const std::string message = messageOf<InputError>([&] { filmSink(folder_.path("a.mp4"), {64, 64, 25.0, "h265"}); });
    EXPECT_NE(message.find("a.mp4: " + other_.path("ffmpeg") +
                           " cannot encode H.265 with libx265 (libx265: ffmpeg "
                           "failed with exit code 1: Unknown encoder 'libx265'); install an ffmpeg that has it, or "
                           "choose another ending or --codec"),
              std::string::npos)
        << message;
    EXPECT_EQ(listed(), 0u);
    make("b.mp4");
}

TEST_F(FilmKinds, OfAv1TakeTheEncoderThatIsThere)
{
    const WithoutEncoder without(other_, "libsvtav1");
    EXPECT_TRUE(probe(make("a.mkv", "av1")).starts_with("av1,98,66,5"));
}

TEST_F(FilmKinds, AndCodecsGoTogetherOrAreRefused)
{
    const auto refused = [&](const std::string& name, const std::string& codec) {
        return messageOf<InputError>([&] { filmSink(folder_.path(name), {64, 64, 25.0, codec}); });
    };
    EXPECT_NE(refused("a.webm", "h264").find("a .webm has no h264; choose --codec vp9 or av1, or another ending"),
              std::string::npos);
    EXPECT_NE(refused("a.mp4", "vp9").find("choose --codec h264, h265 or av1"), std::string::npos);
    EXPECT_EQ(listed(), 0u);
    make("a.gif", "h265");
}

}  // namespace
}  // namespace knuckle::test
