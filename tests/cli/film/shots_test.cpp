#include <fmt/format.h>

#include "tests/cli/cli_fixture.h"

namespace knuckle::test {
namespace {

/// A pair that falls fast and turns; half a second of it stands still or is slow.
class Shots : public CliTest {
protected:
    static constexpr const char* FALL = R"({
        "duration": 0.3, "colliders": [{ "type": "plane" }], "solver": { "timeStep": 0.00416667 },
        "objects": [{ "type": "joined", "name": "pair", "position": [0, 0.6, 0], "velocity": [1, -2, 0],
                      "spin": [0, 0, 300] }],
        "camera": { "position": [0, 1, 3] },
        "cameras": { "near": { "frame": ["pair"], "fieldOfView": 30, "shake": { "amplitude": 1 } },
                     "side": { "position": [3, 1, 0] } },
        "render": { "width": 64, "height": 36 } })";

    Shots() { folder.write("fall.json", FALL); }

    std::string pictureOf(const std::string& output, int frame) const
    {
        return readText(folder.path(fmt::format("{}/frame_{:04}.png", output, frame)));
    }
    /// What a frame shows, without its labels.
    void expectSamePictures(const std::string& one, int frame, const std::string& other, int otherFrame) const
    {
        const RunResult result = run({"compare", fmt::format("{}/frame_{:04}.png", one, frame),
                                      fmt::format("{}/frame_{:04}.png", other, otherFrame), "--max-pixels", "0",
                                      "--threshold", "0"});
        EXPECT_EQ(result.code, 0) << one << " " << frame << ", " << other << " " << otherFrame << ": " << result.out
                                  << result.err;
    }
    void render(const std::string& output, std::vector<std::string> more) const
    {
        more.insert(more.begin(), {"render", "fall.json", "-o", output, "--quiet"});
        const RunResult result = run(more);
        ASSERT_EQ(result.code, 0) << result.err;
    }
    static constexpr const char* SLOW = R"(shots=[{"from":0},{"from":0.1,"timeScale":0.25}])";
    static constexpr const char* MIXED =
        R"(shots=[{"from":0},{"from":0.05,"timeScale":0.3,"camera":"near"},{"from":0.15,"timeScale":0},)"
        R"({"from":0.2,"camera":"side"}])";
};

TEST_F(Shots, OfSlowMotionShowTheStatesOfMoreFramesASecond)
{
    render("slow", {"--set", SLOW});
    render("fine", {"--fps", "240"});
    for (const int frame : {1, 7}) expectSamePictures("slow", frame, "fine", 1 + 4 * (frame - 1));
    for (const int frame : {8, 9, 10, 11, 18}) expectSamePictures("slow", frame, "fine", 25 + frame - 7);
}

TEST_F(Shots, OfFastMotionShowEveryThirdState)
{
    render("fast", {"--set", R"(shots=[{"from":0},{"from":0.05,"timeScale":3}])", "--set", "duration=0.13333"});
    render("moving", {});
    for (int frame = 1; frame <= 4; ++frame) expectSamePictures("fast", frame, "moving", frame);
    for (int frame = 5; frame <= 8; ++frame) expectSamePictures("fast", frame, "moving", 4 + 3 * (frame - 4));
}

TEST_F(Shots, OfFastMotionShowMomentsBetweenStepsAndBlurOnTheWay)
{
    const auto with = [](const std::string& pace) {
        return std::vector<std::string>{"--set",    "shots=[{\"from\":0,\"timeScale\":" + pace + "}]",
                                        "--set",    "solver.timeStep=0.0167",
                                        "--frames", "5"};
    };
    // Ten steps a second of which two and a half are a frame, and twenty-four a frame of as many states.
    render("between", with("2.5"));
    render("after", with("2"));
    EXPECT_NE(pictureOf("between", 5), pictureOf("after", 5));
    std::vector<std::string> blurred = with("20");
    for (const char* word : {"--set", "render.shutter=180", "--set", "render.samples=4"}) blurred.emplace_back(word);
    render("blurred", blurred);
    render("sharp", with("20"));
    EXPECT_NE(pictureOf("blurred", 5), pictureOf("sharp", 5));
}

TEST_F(Shots, StandStillWithAllBits)
{
    render("still", {"--set", R"(shots=[{"from":0},{"from":0.1,"timeScale":0},{"from":0.2}])"});
    render("moving", {});
    for (const int frame : {8, 10, 13}) expectSamePictures("still", frame, "still", 7);
    for (const int frame : {14, 18}) expectSamePictures("still", frame, "moving", frame - 6);
    EXPECT_NE(pictureOf("still", 14), pictureOf("still", 13));
}

TEST_F(Shots, ChangeNoBitOfWhatIsSimulated)
{
    const auto hash = [&](const std::string& shots, const std::string& duration) {
        const RunResult result = run(
            {"render", "fall.json", "-o", "out", "--hash", "--set", shots, "--set", "duration=" + duration});
        return result.out.substr(result.out.find("state hash"));
    };
    const std::string whole = hash("shots=[]", "0.2");
    EXPECT_EQ(hash(R"(shots=[{"from":0},{"from":0.1,"timeScale":0.5,"camera":"near"}])", "0.2833"), whole);
    EXPECT_EQ(hash(R"(shots=[{"from":0,"timeScale":0.5}])", "0.3833"), whole);
    // One frame of 44 steps, which are checked on the way.
    EXPECT_EQ(hash(R"(shots=[{"from":0,"timeScale":11}])", "0.0333"), whole);
}

TEST_F(Shots, AreTheSameInPartAndFromStatesAndAfterAnInterruption)
{
    const std::vector<std::string> coarse{"--set", MIXED, "--set", "solver.timeStep=0.0167"};
    const auto with = [&](std::vector<std::string> more) {
        more.insert(more.begin(), coarse.begin(), coarse.end());
        return more;
    };
    render("whole", with({"--record", "states=run.states"}));
    render("part", with({"--frames", "7:9"}));
    render("gone", with({"--set", "duration=0.2", "--checkpoint", "0"}));
    render("gone", with({"--checkpoint", "0", "--resume"}));
    const RunResult again = run({"render", "--from", "run.states", "-o", "again", "--quiet"});
    ASSERT_EQ(again.code, 0) << again.err;
    for (int frame = 1; frame <= 18; ++frame) {
        EXPECT_EQ(pictureOf("again", frame), pictureOf("whole", frame)) << frame;
        expectSamePictures("gone", frame, "whole", frame);
    }
    for (int frame = 7; frame <= 9; ++frame) EXPECT_EQ(pictureOf("part", frame), pictureOf("whole", frame)) << frame;
}

TEST_F(Shots, OfAnotherPaceAreNotThoseOfTheStates)
{
    render("run", {"--set", SLOW, "--record", "states=run.states"});
    const RunResult other = run({"render", "fall.json", "--from", "run.states", "-o", "other"});
    expectError(other, 2,
                "run.states: its frames are of other moments than the scene's: give shots the `from` and `timeScale` "
                "of its run, and any camera");
    EXPECT_EQ(run({"render", "--from", "run.states", "--camera", "side", "-o", "side", "--quiet"}).code, 0);
    expectError(
        run({"render", "fall.json", "--set", SLOW, "--export", "bodies=b.csv"}), 2,
        "--export: shots of another `timeScale` than 1 show moments that are no frames of the simulation; export "
        "without them: --set 'shots=[]'");
    folder.write("on.json", R"({ "start": { "from": "run.states" }, "diameter": 0.1, "objects": [
        { "type": "joined", "name": "pair", "position": [0, 0.6, 0] }] })");
    expectError(run({"render", "on.json"}), 2,
                "on.json: /start/from: run.states is of a film with slow or fast motion, from which nothing goes on; "
                "record it without: --set 'shots=[]'");
}

TEST_F(Shots, AreFilmedByOneCameraOnDemand)
{
    render("side", {"--camera", "side", "--frames", "3"});
    render("set", {"--set", "camera={\"position\":[3,1,0]}", "--frames", "3"});
    expectSamePictures("side", 3, "set", 3);
    render("around", {"--turntable", "--frames", "1:18"});
    render("auto", {"--camera", "auto", "--frames", "1"});
    EXPECT_NE(pictureOf("around", 1), pictureOf("around", 18));
    EXPECT_EQ(run({"render", "fall.json", "--camera", "sid"}).err,
              "knuckle: fall.json: /render/camera: there is no camera \"sid\"; did you mean \"side\"?\n");
    expectError(run({"render", "fall.json", "--camera", "side", "--turntable"}), 2,
                "--turntable: is a camera of its own; leave out --camera");
}

}  // namespace
}  // namespace knuckle::test
