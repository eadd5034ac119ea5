#include <sys/resource.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <filesystem>

#include "sim/gpu/device/driver_threads.h"
#include "tests/cli/cli_fixture.h"

namespace knuckle {
namespace {

namespace fs = std::filesystem;
using test::RunResult;

/// Causes that end a run: signals, lack of memory, the environment.
class Stop : public test::CliTest {
protected:
    /// A program in place of ffmpeg, whose encoders are fine when they are tried. @returns the variable by which it is
    /// found.
    std::string ffmpeg(const std::string& script) const
    {
        fs::create_directory(folder.path("bin"));
        folder.write("bin/ffmpeg", "#!/bin/sh\ncase $* in *lavfi*) exit 0;; esac\n" + script);
        fs::permissions(folder.path("bin/ffmpeg"), fs::perms::owner_all);
        return "PATH=" + folder.path("bin") + ":/usr/bin:/bin";
    }
    std::vector<std::string> hiddenFiles() const
    {
        std::vector<std::string> files = madeFiles();
        std::erase_if(files, [](const std::string& file) {
            return file.find("/.knuckle") == std::string::npos && !file.starts_with(".knuckle");
        });
        return files;
    }
};

TEST_F(Stop, WhileShadersAreCompiledIsAtOnce)
{
    // Outputs are opened before the first shader: their folder is made.
    const std::string path = ffmpeg("exec cat >/dev/null");
    const RunResult result = run({"-q", "render", scene, "-o", "film.mp4", "--export", "ply=ply"},
                                 {.environment = {path, "MESA_SHADER_CACHE_DISABLE=1"},
                                  .signalAfterFile = SIGTERM,
                                  .waitFor = folder.path("ply")});
    EXPECT_EQ(result.code, 130);
    EXPECT_EQ(result.err, "knuckle: stopped; what was finished is kept\n");
    EXPECT_TRUE(hiddenFiles().empty());
    EXPECT_FALSE(fs::exists(folder.path("film.mp4")));
    EXPECT_FALSE(fs::exists(folder.path("ply/frame_0001.ply"))) << "a frame was simulated";
}

TEST_F(Stop, EndsWhatHangsSoonAndTheSecondTimeAtOnce)
{
    // It reads no frame: a writer waits for it forever.
    const std::string path = ffmpeg("exec sleep 1000");
    for (const bool twice : {false, true}) {
        const RunResult result = run(
            {"-q", "render", scene, "--set", "duration=60", "--size", "640x360", "-o", "out", "-o", "film.mp4"},
            {.environment = {path},
             .signalAfterFile = SIGTERM,
             .waitFor = folder.path("out/frame_0004.png"),
             .signalTwice = twice});
        const auto frame = fs::last_write_time(folder.path("out/frame_0004.png"));
        const double seconds = std::chrono::duration<double>(fs::file_time_type::clock::now() - frame).count();
        EXPECT_EQ(result.code, 130) << result.err;
        EXPECT_LT(seconds, twice ? 3.0 : 15.0);
        EXPECT_TRUE(hiddenFiles().empty());
        fs::remove_all(folder.path("out"));
    }
}

TEST_F(Stop, ForWantOfMemoryIsOneLine)
{
#if defined(__SANITIZE_ADDRESS__)
    GTEST_SKIP() << "the sanitizer has reserved terabytes";
#endif
    if (run({"info"}).out.find("zink") != std::string::npos) GTEST_SKIP() << "its Vulkan driver takes more";
    for (const char* threads : {"0", "1", "2"})
        for (const rlim_t megabytes : {100, 250, 300, 320, 335, 350, 370, 400}) {
            const auto limit = [megabytes] {
                const rlimit space{megabytes << 20, megabytes << 20};
                setrlimit(RLIMIT_AS, &space);
            };
            // With OpenVDB the libraries may take more by themselves, for loading or for their threads.
            if (run({"--version"}, {.inChild = limit}).code != 0) {
                EXPECT_EQ(megabytes, 100u);
                continue;
            }
            const std::string variable = std::string(DRIVER_THREADS_VARIABLE) + "=" + threads;
            for (const std::vector<std::string>& words :
                 std::vector<std::vector<std::string>>{{"-q", "render", scene, "-o", "out"},
                                                       {"-q", "render", scene, "-o", "out", "--size", "1920x1080"},
                                                       {"info"}}) {
                const RunResult result = run(words, {.environment = {variable}, .inChild = limit});
                EXPECT_TRUE(result.code == 0 || result.code == 1)
                    << megabytes << ", " << threads << ": " << result.code;
                EXPECT_TRUE(result.code == 0 || test::isOneLine(result.err)) << result.err;
            }
        }
}

TEST_F(Stop, ByTheEnvironmentNamesTheVariable)
{
    for (const std::string variable : {"MESA_GL_VERSION_OVERRIDE=3.0", "GALLIUM_DRIVER=none",
                                       "LIBGL_DRIVERS_PATH=/none", "__EGL_VENDOR_LIBRARY_FILENAMES=/none.json"}) {
        const RunResult result = run({"-q", "render", scene, "-o", "out"}, {.environment = {variable}});
        if (result.code == 0) continue;  // this driver ignores the variable
        EXPECT_EQ(result.code, 3) << variable;
        EXPECT_TRUE(test::isOneLine(result.err)) << result.err;
        EXPECT_NE(result.err.find(variable), std::string::npos) << result.err;
        EXPECT_TRUE(result.err.ends_with(": unset that; `knuckle doctor` says more\n")) << result.err;
    }
}

TEST_F(Stop, OfOneStreamDoesNotMixItWithTheOther)
{
    // Both streams into one file.
    const std::string both = folder.path("both");
    const RunResult result = run({"check", "tiny.json", "none.json", "tiny.json"},
                                 {.inChild = [] { dup2(STDOUT_FILENO, STDERR_FILENO); }, .standardOutput = both});
    EXPECT_EQ(result.code, 2);
    const std::string text = test::readText(both);
    EXPECT_LT(text.find("particles"), text.find("none.json: there is no such file")) << text;
    EXPECT_LT(text.find("none.json"), text.rfind("particles")) << text;
}

}  // namespace
}  // namespace knuckle
