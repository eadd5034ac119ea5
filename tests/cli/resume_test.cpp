#include <fmt/format.h>

#include <csignal>
#include <filesystem>

#include "tests/cli/cli_fixture.h"

namespace knuckle::test {
namespace {

namespace fs = std::filesystem;

/// A run of 30 frames with outputs of each kind, a checkpoint after every frame.
class Resume : public CliTest {
protected:
    static std::vector<std::string> outputs()
    {
        return {"-o",
                "out/f",
                "-o",
                "out/film.mp4",
                "--export",
                "ply=out/ply",
                "--export",
                "vtk=out/vtk",
                "--export",
                "layers=out/layers",
                "--export",
                "bodies=out/b.csv",
                "--export",
                "measures=out/m.csv",
                "--export",
                "gltf=out/g.glb",
                "--record",
                "states=out/r.states",
                "--record-every",
                "7"};
    }
    RunResult render(std::vector<std::string> more, RunOptions options = {}) const
    {
        std::vector<std::string> words{"render", "tiny.json", "--set", "duration=0.5", "--checkpoint", "0"};
        for (const std::string& word : outputs()) words.push_back(word);
        words.insert(words.end(), more.begin(), more.end());
        return run(words, std::move(options));
    }
    /// Ends the run once a frame is there. @returns whether it was ended before its end.
    bool killAtFrame(int frame, int signal, std::vector<std::string> more = {"--resume"}) const
    {
        return render(std::move(more), {.environment = {"LP_NUM_THREADS=0"},
                                        .signalAfterFile = signal,
                                        .waitFor = folder.path(fmt::format("out/f/frame_{:04}.png", frame))})
                   .code != 0;
    }
    /// Everything that a run leaves but its checkpoint.
    std::map<std::string, std::string> left() const
    {
        std::map<std::string, std::string> files;
        for (const std::string& name : listFolder(folder.path("out")))
            if (name.find(".checkpoint") == std::string::npos && fs::is_regular_file(folder.path("out/" + name)))
                files[name] = readText(folder.path("out/" + name));
        return files;
    }
    /// What an undisturbed run leaves, without checkpoints and with them.
    std::map<std::string, std::string> undisturbed()
    {
        std::vector<std::string> words{"render", "tiny.json", "--set", "duration=0.5"};
        for (const std::string& word : outputs()) words.push_back(word);
        EXPECT_EQ(run(words).code, 0);
        std::map<std::string, std::string> files = left();
        EXPECT_EQ(files.size(), 30u + 30u + 31u + 32u + 5u);
        fs::remove_all(folder.path("out"));
        return files;
    }
    void expectLeft(const std::map<std::string, std::string>& wanted) const
    {
        const std::map<std::string, std::string> found = left();
        for (const auto& [name, text] : wanted) {
            const auto own = found.find(name);
            EXPECT_TRUE(own != found.end() && own->second == text) << name;
        }
        EXPECT_EQ(found.size(), wanted.size());
    }
    std::string checkpoint(const std::string& file) const { return folder.path("out/f.checkpoint/" + file); }
    void damage(const std::string& path, size_t byte) const
    {
        std::string text = readText(path);
        ASSERT_LT(byte, text.size());
        text[byte] = static_cast<char>(text[byte] ^ 4);
        std::ofstream(path, std::ios::binary) << text;
    }
};

TEST_F(Resume, EndsWithTheBytesOfAnUndisturbedRun)
{
    const auto wanted = undisturbed();
    for (const int frame : {2, 9, 20}) EXPECT_TRUE(killAtFrame(frame, SIGKILL)) << frame;
    // On other threads, too.
    const RunResult end = render({"--resume"}, {.environment = {"LP_NUM_THREADS=2"}});
    ASSERT_EQ(end.code, 0) << end.err;
    EXPECT_NE(end.err.find("note: goes on after frame "), std::string::npos) << end.err;
    expectLeft(wanted);
    // And again, when all is done.
    const RunResult again = render({"--resume"});
    ASSERT_EQ(again.code, 0) << again.err;
    EXPECT_NE(again.err.find("note: goes on after frame 30, "), std::string::npos) << again.err;
    expectLeft(wanted);
}

TEST_F(Resume, GoesOnAfterCtrlC)
{
    const auto wanted = undisturbed();
    const RunResult stopped = render({"--resume"},
                                     {.signalAfterFile = SIGINT, .waitFor = folder.path("out/f/frame_0005.png")});
    EXPECT_EQ(stopped.code, 130);
    EXPECT_NE(stopped.err.find("note: out/f.checkpoint has all up to frame "), std::string::npos) << stopped.err;
    ASSERT_EQ(render({"--resume"}).code, 0);
    expectLeft(wanted);
}

TEST_F(Resume, LeavesNothingTemporary)
{
    ASSERT_TRUE(killAtFrame(9, SIGKILL));
    ASSERT_EQ(render({"--resume"}).code, 0);
    for (const std::string& name : listFolder(folder.path("out")))
        EXPECT_EQ(name.find(".knuckle."), std::string::npos) << name;
}

TEST_F(Resume, ExtendsARunThatIsDone)
{
    const auto wanted = undisturbed();
    std::vector<std::string> shorter{"--set", "duration=0.3"};
    ASSERT_EQ(render(shorter).code, 0);
    const RunResult longer = render({"--resume"});
    ASSERT_EQ(longer.code, 0) << longer.err;
    EXPECT_NE(longer.err.find("note: goes on after frame 18, "), std::string::npos) << longer.err;
    expectLeft(wanted);
    const RunResult back = render({"--resume", "--set", "duration=0.3"});
    expectError({back.code, back.out, back.err.substr(back.err.find("knuckle: out"))}, 2,
                "out/f.checkpoint: has come to frame 30, and the last is 18; raise /duration or begin anew without "
                "--resume");
}

TEST_F(Resume, DrawsAgainWhatIsMissingOrDamaged)
{
    const auto wanted = undisturbed();
    ASSERT_TRUE(killAtFrame(20, SIGKILL));
    fs::remove(folder.path("out/f/frame_0003.png"));
    damage(folder.path("out/f/frame_0011.png"), 100);
    damage(checkpoint("film_2/frame_000007"), 200);
    const RunResult end = render({"--resume"});
    ASSERT_EQ(end.code, 0) << end.err;
    EXPECT_NE(end.err.find("note: frame 3 is missing or damaged: simulates from the start"), std::string::npos)
        << end.err;
    EXPECT_NE(end.out.find("30 frames, "), std::string::npos) << end.out;
    expectLeft(wanted);
}

TEST_F(Resume, TakesTheCheckpointBeforeADamagedOne)
{
    const auto wanted = undisturbed();
    ASSERT_TRUE(killAtFrame(20, SIGKILL));
    const std::string whole = readText(checkpoint("current.states"));
    for (int tenth = 0; tenth < 10; ++tenth) {
        fs::copy(folder.path("out"), folder.path("kept"), fs::copy_options::recursive);
        std::ofstream(checkpoint("current.states"), std::ios::binary)
            << whole.substr(0, whole.size() * static_cast<size_t>(tenth) / 10);
        fs::remove(checkpoint("next.states"));
        const RunResult end = render({"--resume"});
        ASSERT_EQ(end.code, 0) << end.err;
        EXPECT_NE(end.err.find("note: out/f.checkpoint/current.states: "), std::string::npos) << end.err;
        EXPECT_NE(end.err.find("note: goes on after frame "), std::string::npos) << end.err;
        expectLeft(wanted);
        fs::remove_all(folder.path("out"));
        fs::rename(folder.path("kept"), folder.path("out"));
    }
}

TEST_F(Resume, BeginsAnewWhereNoCheckpointIsWhole)
{
    const auto wanted = undisturbed();
    ASSERT_TRUE(killAtFrame(9, SIGKILL));
    damage(checkpoint("log"), 40);
    const RunResult end = render({"--resume"});
    ASSERT_EQ(end.code, 0) << end.err;
    EXPECT_NE(end.err.find("note: no checkpoint is whole: begins anew"), std::string::npos) << end.err;
    expectLeft(wanted);
}

TEST_F(Resume, IsRefusedForAnotherRun)
{
    ASSERT_EQ(render({"--quiet"}).code, 0);
    const auto refused = [&](std::vector<std::string> more, const std::string& part) {
        more.insert(more.end(), {"--resume", "--quiet"});
        const RunResult result = render(more);
        EXPECT_EQ(result.code, 2);
        EXPECT_TRUE(isOneLine(result.err)) << result.err;
        EXPECT_NE(result.err.find(part), std::string::npos) << result.err;
    };
    refused({"--set", "objects.0.position.1=0.4"}, "was left by another run: the hash of the scene's world is ");
    refused({"--set", "camera.fieldOfView=20"}, "was left by another run: the hash of the scene's file is ");
    refused({"--export", "bodies=other.csv"}, "was left by a run with other outputs, -o out/f -o out/film.mp4 ");
    // A film's frames of another size are of no use, however loose.
    const RunResult resized = render({"--size", "32x18", "--resume=loose", "--quiet"});
    EXPECT_EQ(resized.code, 2);
    EXPECT_NE(resized.err.find("was left by a run with other outputs, -o out/f "), std::string::npos) << resized.err;
    // A change of the picture's settings goes on when the user wants it so.
    EXPECT_EQ(render({"--set", "camera.fieldOfView=20", "--resume=loose", "--quiet"}).code, 0);
    EXPECT_EQ(render({"--resume=no"}).err, "knuckle: --resume=no: must be --resume or --resume=loose\n");
    EXPECT_EQ(run({"render", "tiny.json", "-o", "-", "--checkpoint", "1"}).err,
              "knuckle: --checkpoint: -o - is a stream, with which no later run can go on; name a file or a folder\n");
}

TEST_F(Resume, IsHarmlessOnAFirstRun)
{
    const auto wanted = undisturbed();
    const RunResult first = render({"--resume"});
    ASSERT_EQ(first.code, 0) << first.err;
    EXPECT_EQ(first.err.find("checkpoint"), std::string::npos) << first.err;
    expectLeft(wanted);
}

}  // namespace
}  // namespace knuckle::test
