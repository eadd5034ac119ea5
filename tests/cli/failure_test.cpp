#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>

#include "tests/cli/cli_fixture.h"
#include "tests/places.h"

namespace knuckle {
namespace {

using test::RunResult;
using Failure = test::CliTest;

/// Limits the size of files: the writer gets an error as from a full disk, not a signal.
std::function<void()> limitFiles(rlim_t bytes)
{
    return [bytes] {
        std::signal(SIGXFSZ, SIG_IGN);
        const rlimit limit{bytes, bytes};
        setrlimit(RLIMIT_FSIZE, &limit);
    };
}

TEST_F(Failure, OfASceneIsOneLineAndLeavesNothing)
{
    const struct {
        const char* set;
        const char* message;
    } cases[] = {
        {"durration=3", "/durration: unknown field; did you mean \"duration\"?"},
        {"duration=\"long\"", "/duration: is \"long\" (a string), must be a number [s]"},
        {"duration=0", "/duration: 0 must be above 0 [s]"},
        {"solver.iterations=0", "/solver/iterations: 0 is below the minimum 1"},
        {"objects=[{\"type\":\"rigid\",\"shape\":\"sphere\",\"radius\":-1}]",
         "/objects/0/radius: -1 must be above 0 [m]"},
        {"objects=[{\"type\":\"rigid\",\"shape\":\"box\",\"size\":[20,20,5]}]",
         "/objects/0: brings the scene to 2000000 particles, the limit is 1000000; raise /diameter, or make it smaller "
         "or fewer"},
        {"objects=[{\"type\":\"actor\",\"file\":\"none.glb\"}]",
         "/objects/0/file: there is no file none.glb; paths are relative to the scene"},
    };
    for (const auto& entry : cases) {
        expectError(run({"render", "tiny.json", "--set", entry.set}), 2, std::string("tiny.json: ") + entry.message);
        EXPECT_TRUE(madeFiles().empty()) << entry.set;
    }
    expectError(run({"render", "none.json"}), 2, "none.json: there is no such file");
}

TEST_F(Failure, OfAModelIsOneLineAndLeavesNothing)
{
    folder.write("empty.glb", "");
    folder.write("words.glb", "this is not a model\n");
    folder.write("half.gltf", "{ \"asset\": { \"version\": \"2.0\" }, \"meshes\": [ {");
    for (const char* file : {"empty.glb", "words.glb", "half.gltf", "none.fbx"}) {
        const RunResult result = run({"voxelize", file, "-o", "actor.json"});
        EXPECT_EQ(result.code, 2) << file;
        EXPECT_TRUE(test::isOneLine(result.err)) << result.err;
        EXPECT_NE(result.err.find(file), std::string::npos) << result.err;
        EXPECT_FALSE(std::filesystem::exists(folder.path("actor.json")));
    }
    EXPECT_EQ(madeFiles().size(), 3u);
    folder.write("notes.md", "# Notes\n");
    expectError(run({"voxelize", "notes.md"}), 2,
                "notes.md: it cannot be read as a model (No suitable reader found for the file format of file "
                "\"notes.md\"); export it as glTF, FBX, Collada or BVH");
}

TEST_F(Failure, AnActorThatNoSceneCouldUseIsRefused)
{
    const std::string figure = test::inSource("assets/models/humanoid.glb");
    const RunResult coarse = run({"voxelize", figure, "--diameter", "0.6", "-o", "actor.json"});
    EXPECT_EQ(coarse.code, 2);
    EXPECT_TRUE(coarse.err.starts_with("knuckle: " + figure + ": ")) << coarse.err;
    EXPECT_NE(coarse.err.find("use --particles 1000, or a smaller --diameter"), std::string::npos) << coarse.err;
    const RunResult tiny = run({"voxelize", figure, "--height", "0.012", "-o", "actor.json"});
    EXPECT_EQ(tiny.code, 2);
    EXPECT_NE(tiny.err.find("make it larger by --height"), std::string::npos) << tiny.err;
    EXPECT_TRUE(madeFiles().empty());
}

TEST_F(Failure, ToFindAPlaceForTheFramesComesBeforeSimulating)
{
    folder.write("file", "in the way");
    for (const std::vector<std::string>& words :
         std::vector<std::vector<std::string>>{{"-o", "file"},
                                               {"-o", "file/out"},
                                               {"-o", "/proc/frames"},
                                               {"-o", "/proc/film.mp4"},
                                               {"-o", "out", "--stats", "/proc/stats.json"},
                                               {"-o", "out", "--export", "ply=file"},
                                               {"-o", "out", "--export", "bodies=/proc/bodies.csv"}}) {
        std::vector<std::string> arguments{"render", scene, "--set", "duration=3600"};
        arguments.insert(arguments.end(), words.begin(), words.end());
        const RunResult result = run(arguments);
        EXPECT_EQ(result.code, 2) << words.back();
        EXPECT_TRUE(test::isOneLine(result.err)) << result.err;
        std::filesystem::remove_all(folder.path("out"));
    }
    EXPECT_EQ(madeFiles(), std::vector<std::string>{"file"});
}

TEST_F(Failure, ToFindFfmpegSaysWhatToDo)
{
    const RunResult result = run({"render", scene, "-o", "film.mp4"}, {.environment = {"PATH=/nonexistent"}});
    EXPECT_EQ(result.code, 2);
    EXPECT_TRUE(test::isOneLine(result.err)) << result.err;
    EXPECT_NE(result.err.find("ffmpeg"), std::string::npos);
    EXPECT_TRUE(madeFiles().empty());
}

TEST_F(Failure, ToStartAThreadIsOneLine)
{
    if (geteuid() != 0) GTEST_SKIP() << "of this user other processes count as well";
    // A user of whom nothing runs, and who may have so many threads.
    constexpr uid_t NOBODY_ELSE = 64321;
    std::filesystem::permissions(folder.path(), std::filesystem::perms::all);
    const auto runWith = [&](rlim_t threads, const std::vector<std::string>& words) {
        const auto become = [threads] {
            const rlimit limit{threads, threads};
            if (setrlimit(RLIMIT_NPROC, &limit) != 0 || setuid(NOBODY_ELSE) != 0) _exit(99);
        };
        return run(words, {.environment = {"MESA_SHADER_CACHE_DISABLE=true"}, .inChild = become});
    };
    uint32_t refused = 0;
    const auto expectOneLine = [&](rlim_t threads, const std::vector<std::string>& words) {
        // Some libraries start threads as they are loaded, and end the program without.
        if (runWith(threads, {"--version"}).code != 0) return;
        const RunResult result = runWith(threads, words);
        if (result.code == 0) return;
        ++refused;
        expectError(result, 1,
                    "the system gives no more threads or processes; allow more (ulimit -u; of a container "
                    "--pids-limit); `knuckle doctor` says more");
    };
    for (rlim_t threads = 1; threads < 9; ++threads) expectOneLine(threads, {"--quiet", "render", "tiny.json"});
    for (const rlim_t threads : {rlim_t{12}, rlim_t{30}}) expectOneLine(threads, {"serve", "tiny.json", "--port", "0"});
    EXPECT_GT(refused, 2u);
}

TEST_F(Failure, OfTheDiskLeavesNothingHalfWritten)
{
    // A frame of 64 x 36 pixels, its film and 55 particles are all larger than this; reading has no such limit.
    const test::RunOptions full{
        .environment = {"MESA_SHADER_CACHE_DISABLE=1"}, .inChild = limitFiles(400), .standardOutput = "/dev/null"};
    if (run({"info"}, full).code == 1000 + SIGBUS)
        GTEST_SKIP() << "this driver keeps its memory in files, as lavapipe does";
    for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
             {"-o", "out"}, {"-o", "film.mp4"}, {"-o", "out2", "--export", "ply=ply"}}) {
        std::vector<std::string> arguments{"render", scene, "--quiet"};
        arguments.insert(arguments.end(), words.begin(), words.end());
        const RunResult result = run(arguments, full);
        EXPECT_EQ(result.code, 1) << words.back() << ": " << result.err;
        EXPECT_TRUE(test::isOneLine(result.err)) << result.err;
    }
    for (const std::string& path : madeFiles()) EXPECT_TRUE(std::filesystem::is_directory(folder.path(path))) << path;
}

TEST_F(Failure, OfADeviceThatIsAlwaysFullIsToldToo)
{
    const RunResult result = run({"render", scene, "-o", "out", "--quiet", "--stats", "/dev/full"});
    EXPECT_EQ(result.code, 1);
    EXPECT_TRUE(result.err.starts_with("knuckle: /dev/full cannot be written")) << result.err;
}

TEST_F(Failure, OfOutputsThatAreInEachOthersWayComesBeforeTheRun)
{
    expectError(run({"render", scene, "-o", "out", "--export", "gltf=motion.gltf"}), 2,
                "--export gltf=motion.gltf: it is written as binary glTF; name it motion.glb");
    const RunResult twice = run(
        {"render", scene, "-o", "out", "--export", "bodies=a.csv", "--export", "measures=./a.csv"});
    EXPECT_EQ(twice.code, 2);
    EXPECT_NE(twice.err.find("a.csv would be written twice; give each output a name of its own"), std::string::npos)
        << twice.err;
    EXPECT_TRUE(madeFiles().empty());
}

TEST_F(Failure, ByCtrlCKeepsWhatIsFinishedAndRemovesTheRest)
{
    for (const int signal : {SIGINT, SIGTERM}) {
        const RunResult result = run({"render", scene, "--set", "duration=3000", "-o", "out", "-o", "film.mp4",
                                      "--export", "bodies=bodies.csv", "--quiet"},
                                     {.signalAfterFile = signal, .waitFor = folder.path("out/frame_0003.png")});
        EXPECT_EQ(result.code, 130) << result.err;
        for (const std::string& path : madeFiles()) {
            const bool frame = path.starts_with("out/frame_") && path.ends_with(".png");
            EXPECT_TRUE(path == "out" || frame) << path;
        }
        EXPECT_TRUE(std::filesystem::exists(folder.path("out/frame_0001.png")));
        std::filesystem::remove_all(folder.path("out"));
    }
}

TEST_F(Failure, ToFindADeviceSaysSo)
{
    // Without the vendors' descriptions libEGL finds no driver.
    const RunResult result = test::runKnuckle(
        {"render", scene}, {.folder = folder.path(), .environment = {"__EGL_VENDOR_LIBRARY_DIRS=/nonexistent"}});
    EXPECT_EQ(result.code, 3) << result.err;
    EXPECT_TRUE(test::isOneLine(result.err)) << result.err;
    EXPECT_TRUE(result.err.ends_with("; `knuckle doctor` says more\n")) << result.err;
}

}  // namespace
}  // namespace knuckle
