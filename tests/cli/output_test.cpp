#include <fcntl.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <unistd.h>

#include <filesystem>
#include <thread>

#include "app/json/json.h"
#include "render/output/ffmpeg.h"
#include "render/picture/image.h"
#include "tests/cli/cli_fixture.h"

namespace knuckle {
namespace {

namespace fs = std::filesystem;
using test::RunResult;

/// With a model: a cube of 1 m.
class Output : public test::CliTest {
protected:
    Output()
        : model(folder.write("cube.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 0 0 1\nv 1 0 1\nv 0 1 1\nv 1 1 1\n"
                                         "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n"))
    {
        const Image black{8, 8, std::vector<uint8_t>(192, 0)};
        writePng(folder.path("a.png"), black);
        writePng(folder.path("b.png"), black);
    }

    RunResult voxelize(std::vector<std::string> words, test::RunOptions options = {}) const
    {
        words.insert(words.begin(), {"-q", "voxelize", model, "--particles", "64"});
        return run(words, std::move(options));
    }
    /// A device such as /dev/null in the test's folder. @returns its path; empty if devices are not allowed.
    std::string device(const std::string& name, unsigned minor) const
    {
        const std::string path = folder.path(name);
        if (mknod(path.c_str(), S_IFCHR | 0666, makedev(1, minor)) != 0) return {};
        const int file = open(path.c_str(), O_WRONLY | O_CLOEXEC);
        close(file);
        return file >= 0 ? path : "";
    }
    std::string model;
};

/// Commands that each write to one file.
std::vector<std::vector<std::string>> writers(const std::string& scene, const std::string& model,
                                              const std::string& path)
{
    return {{"voxelize", model, "--particles", "64", "-o", path},
            {"voxelize", model, "--particles", "64", "--preview", path},
            {"compare", "a.png", "b.png", "--difference", path},
            {"render", scene, "-o", "out", "--stats", path},
            {"render", scene, "-o", "out", "--export", "bodies=" + path},
            {"render", scene, "-o", "out", "--export", "measures=" + path},
            {"render", scene, "-o", "out", "--export", "gltf=" + path}};
}

TEST_F(Output, IsWrittenToADeviceWhichStays)
{
    const std::string full = device("full", 7), null = device("null", 3);
    if (full.empty() || null.empty()) GTEST_SKIP() << "devices cannot be made here";
    for (const std::string& path : {full, null}) {
        auto commands = writers(scene, model, path);
        if (!findProgram("ffmpeg").empty()) commands.push_back({"render", scene, "-o", path});
        for (const std::vector<std::string>& words : commands) {
            const RunResult result = run(words);
            EXPECT_EQ(result.code, path == full ? 1 : 0) << words[0] << " " << words.back() << ": " << result.err;
            EXPECT_EQ(result.err.find("No space left on device") != std::string::npos, path == full) << result.err;
            EXPECT_TRUE(fs::is_character_file(path)) << words[0] << " " << words.back();
        }
    }
}

TEST_F(Output, OnStandardOutputHasItAlone)
{
    for (const char* path : {"-", "/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"}) {
        const RunResult actor = run({"voxelize", model, "--particles", "64", "-o", path});
        ASSERT_EQ(actor.code, 0) << actor.err;
        EXPECT_EQ(parseJson(actor.out, path)["format"], "knuckle-actor");
        EXPECT_NE(actor.err.find(" particles of "), std::string::npos) << actor.err;
        const RunResult difference = run({"compare", "a.png", "b.png", "--difference", path});
        EXPECT_EQ(difference.out, test::readText(folder.path("a.png")));
        EXPECT_TRUE(difference.err.starts_with("equal: ")) << difference.err;
        const RunResult stats = run({"render", scene, "-o", "out", "--hash", "--stats", path});
        EXPECT_EQ(parseJson(stats.out, path)["frames"], 4) << stats.err;
        EXPECT_NE(stats.err.find("state hash"), std::string::npos) << stats.err;
    }
}

TEST_F(Output, IsAddedToWhatTheShellHasOpened)
{
    folder.write("log", "before\n");
    const auto append = [this](int descriptor) {
        return [this, descriptor] { dup2(open(folder.path("log").c_str(), O_WRONLY | O_APPEND), descriptor); };
    };
    ASSERT_EQ(run({"-q", "render", scene, "-o", "out", "--export", "bodies=/dev/fd/7"}, {.inChild = append(7)}).code,
              0);
    EXPECT_TRUE(test::readText(folder.path("log")).starts_with("before\nframe,body"))
        << test::readText(folder.path("log"));
}

TEST_F(Output, OfAFilmIntoAStreamNeedsNoWayBack)
{
    if (findProgram("ffmpeg").empty()) GTEST_SKIP() << "ffmpeg is not installed";
    const RunResult film = run({"-q", "render", scene, "-o", "-"});
    ASSERT_EQ(film.code, 0) << film.err;
    EXPECT_EQ(film.out.substr(4, 4), "ftyp");
    EXPECT_NE(film.out.find("moof"), std::string::npos);
    // The name of a FIFO gives its format, and the program waits for its reader.
    const std::string fifo = folder.path("film.MKV");
    ASSERT_EQ(mkfifo(fifo.c_str(), 0600), 0);
    std::string read;
    std::thread reader([&] { read = test::readText(fifo); });
    EXPECT_EQ(run({"-q", "render", scene, "-o", "film.MKV"}).code, 0);
    reader.join();
    EXPECT_EQ(read.substr(0, 4), "\x1a\x45\xdf\xa3");
    EXPECT_TRUE(fs::is_fifo(fifo));
}

TEST_F(Output, WhoseReaderHasGoneIsOneLine)
{
    const auto closedPipe = [] {
        int ends[2];
        if (pipe(ends) != 0) _exit(125);
        close(ends[0]);
        dup2(ends[1], STDOUT_FILENO);
    };
    for (const std::vector<std::string>& words : writers(scene, model, "-")) {
        const RunResult result = run(words, {.inChild = closedPipe});
        EXPECT_EQ(result.code, 1) << words[0] << " " << words.back();
        EXPECT_NE(result.err.find("knuckle: standard output cannot be written: its reader has gone\n"),
                  std::string::npos)
            << result.err;
    }
}

TEST_F(Output, ThroughALinkIsWrittenToWhatItNames)
{
    folder.write("there.json", "old");
    fs::create_directory(folder.path("sub"));
    fs::create_symlink("../there.json", folder.path("sub/link.json"));
    fs::create_symlink("new.json", folder.path("dangling.json"));
    fs::create_symlink("nowhere/new.json", folder.path("lost.json"));
    fs::create_symlink("loop.json", folder.path("loop.json"));
    for (const auto& [link, target] : {std::pair{"sub/link.json", "there.json"}, {"dangling.json", "new.json"}}) {
        EXPECT_EQ(voxelize({"-o", link}).code, 0);
        EXPECT_TRUE(fs::is_symlink(folder.path(link)));
        EXPECT_FALSE(fs::is_symlink(folder.path(target)));
        EXPECT_TRUE(test::readText(folder.path(target)).starts_with("{\n  \"format\"")) << target;
    }
    expectError(voxelize({"-o", "lost.json"}), 2,
                "lost.json cannot be written: No such file or directory; choose another place");
    expectError(voxelize({"-o", "loop.json"}), 2,
                "loop.json cannot be written: Too many levels of symbolic links; choose another place");
    EXPECT_FALSE(fs::exists(folder.path("nowhere")));
}

TEST_F(Output, MayHaveTheLongestNameThereIs)
{
    for (const size_t length : {size_t{240}, size_t{255}}) {
        const std::string name = std::string(length - 5, 'n') + ".json";
        EXPECT_EQ(voxelize({"-o", name}).code, 0) << length;
        EXPECT_TRUE(fs::exists(folder.path(name)));
    }
    std::string deep;
    for (int i = 0; i < 700; ++i) deep += "folder/";
    for (const std::string& path : {std::string(251, 'n') + ".json", deep + "a.json"}) {
        const RunResult result = voxelize({"-o", path});
        EXPECT_EQ(result.code, 2);
        EXPECT_TRUE(test::isOneLine(result.err)) << result.err;
        EXPECT_NE(result.err.find("File name too long; choose another place"), std::string::npos) << result.err;
        EXPECT_LT(result.err.size(), 300u);
    }
}

TEST_F(Output, InAWorkingFolderThatIsGoneIsRefused)
{
    const auto leave = [this] {
        const std::string gone = folder.path("gone");
        if (mkdir(gone.c_str(), 0700) != 0 || chdir(gone.c_str()) != 0 || rmdir(gone.c_str()) != 0) _exit(125);
    };
    for (const char* path : {"out", "film.mp4"})
        expectError(run({"render", scene, "-o", path}, {.inChild = leave}), 2,
                    std::string(path) + ": the working folder is no longer there; go to another");
    EXPECT_EQ(voxelize({"-o", "-"}, {.inChild = leave}).code, 0);
}

TEST_F(Output, OfAFilmIsNoFolder)
{
    fs::create_directory(folder.path("film.mp4"));
    expectError(run({"render", scene, "-o", "film.mp4"}), 2,
                "-o film.mp4: is a folder; name the film otherwise, or film.mp4/ for frames");
    EXPECT_EQ(run({"-q", "render", scene, "-o", "film.mp4/"}).code, 0);
    EXPECT_TRUE(fs::exists(folder.path("film.mp4/frame_0001.png")));
}

}  // namespace
}  // namespace knuckle
