#include <fmt/format.h>

#include "tests/cli/cli_fixture.h"

namespace knuckle::test {
namespace {

/// A pair that flies past cameras that stand still, follow it and keep it whole.
class FilmCameras : public CliTest {
protected:
    static constexpr const char* FLIGHT = R"({
        "duration": 0.3, "colliders": [{ "type": "plane" }],
        "objects": [{ "type": "joined", "name": "pair", "position": [0, 0.6, 0], "velocity": [3, 1, 0],
                      "spin": [0, 0, 20] }],
        "camera": { "position": [0, 1, 3] },
        "cameras": { "after": { "kind": "follow", "follow": "pair" }, "whole": { "frame": ["pair"] } },
        "render": { "width": 64, "height": 48 } })";
    static constexpr const char* SHARED =
        R"(shots=[{"from":0,"beside":"after"},{"from":0.1,"camera":"after","inset":"whole"},)"
        R"({"from":0.2,"camera":"whole","beside":"after"}])";

    FilmCameras() { folder.write("flight.json", FLIGHT); }

    RunResult render(std::vector<std::string> more) const
    {
        more.insert(more.begin(), {"render", "flight.json"});
        return run(more);
    }
    void expectRendered(std::vector<std::string> more) const
    {
        more.emplace_back("--quiet");
        const RunResult result = render(more);
        ASSERT_EQ(result.code, 0) << result.err;
        EXPECT_EQ(result.err, "");
    }
    /// What frames show, without their labels.
    void expectSamePictures(const std::string& one, const std::string& other) const
    {
        const RunResult result = run({"compare", one, other, "--max-pixels", "0", "--threshold", "0"});
        EXPECT_EQ(result.code, 0) << one << ", " << other << ": " << result.out << result.err;
        EXPECT_EQ(listFolder(folder.path(one)).size(), 18u);
    }
};

TEST_F(FilmCameras, EachHasAFilmOfTheSameRun)
{
    expectRendered({"-o", "cut", "--camera", "after=a", "--camera", "whole=w", "--camera", "auto=all"});
    expectRendered({"-o", "cutAlone"});
    expectRendered({"-o", "aAlone", "--camera", "after"});
    expectRendered({"-o", "wAlone", "--camera", "whole"});
    expectRendered({"-o", "allAlone", "--camera", "auto"});
    for (const char* name : {"cut", "a", "w", "all"}) expectSamePictures(name, std::string(name) + "Alone");
    // Without any -o there is no other film, and a camera may have several.
    expectRendered({"--camera", "whole=only", "--camera", "whole=only.mp4"});
    expectSamePictures("only", "w");
    for (const std::string& name : madeFiles()) EXPECT_FALSE(name.starts_with("out")) << name;
}

TEST_F(FilmCameras, GoOnAfterAnInterruptionAsTheyWould)
{
    const auto with = [](const std::string& end, std::vector<std::string> more) {
        const std::vector<std::string> words{"-o",       "cut" + end,     "--camera", "after=a" + end,
                                             "--camera", "whole=w" + end, "--set",    SHARED};
        more.insert(more.begin(), words.begin(), words.end());
        return more;
    };
    expectRendered(with("", {}));
    expectRendered(with("Gone", {"--set", "duration=0.15", "--checkpoint", "0"}));
    expectRendered(with("Gone", {"--checkpoint", "0", "--resume"}));
    for (const char* name : {"cut", "a", "w"}) expectSamePictures(name, std::string(name) + "Gone");
    expectError(render({"-o", "cutGone", "--camera", "after=wGone", "--camera", "whole=aGone", "--set", SHARED,
                        "--checkpoint", "0", "--resume"}),
                2,
                "cutGone.checkpoint: was left by a run with other outputs, -o cutGone --camera after=aGone --camera "
                "whole=wGone --size 64x48 --frames 1:; give the same, or begin anew without --resume");
}

TEST_F(FilmCameras, AreTheSameFromStates)
{
    expectRendered({"-o", "cut", "--camera", "after=a", "--set", SHARED, "--record", "states=run.states"});
    const RunResult again = run(
        {"render", "--from", "run.states", "-o", "cutAgain", "--camera", "after=aAgain", "--quiet"});
    ASSERT_EQ(again.code, 0) << again.err;
    for (const char* name : {"cut", "a"}) expectSamePictures(name, std::string(name) + "Again");
}

TEST_F(FilmCameras, LeaveOutPicturesThatAreThereEachForItself)
{
    expectRendered({"-o", "cut", "--camera", "after=a"});
    const std::string lost = folder.path("a/frame_0009.png"), text = readText(lost);
    std::filesystem::remove(lost);
    const RunResult result = render({"-o", "cut", "--camera", "after=a", "--skip-existing"});
    EXPECT_EQ(result.code, 0) << result.err;
    EXPECT_NE(result.out.find("9 frames, 1 of them drawn"), std::string::npos) << result.out;
    EXPECT_EQ(readText(lost), text);
}

TEST_F(FilmCameras, AreToldInOneLineWhereTheyAreWrong)
{
    expectError(render({"--camera", "aftr=a.mp4"}), 2,
                "--camera aftr=a.mp4: there is no camera \"aftr\"; did you mean \"after\"?");
    expectError(render({"--camera", "after", "--camera", "whole"}), 2,
                "--camera after, whole: one films everything; give others an output of their own, as --camera "
                "whole=whole.mp4");
    expectError(render({"--camera", "after="}), 2,
                "--camera after=: must be NAME for everything, or NAME=OUTPUT as often as there are outputs for "
                "cameras");
    expectError(render({"--camera", "after=a.mp4", "--camera", "whole=a.mp4"}), 2,
                folder.path("a.mp4") + " would be written twice; give each output a name of its own");
    expectError(render({"tiny.json", "--camera", "after=a.mp4"}), 2,
                "several scenes: --camera NAME=OUTPUT is for one at a time; give --camera NAME alone");
}

}  // namespace
}  // namespace knuckle::test
