#include <fmt/format.h>

#include "render/picture/image.h"
#include "tests/cli/cli_fixture.h"

namespace knuckle::test {
namespace {

class States : public CliTest {
protected:
    /// Runs the scene with its states in run.states.
    void record(std::vector<std::string> more = {})
    {
        std::vector<std::string> words{"render", "tiny.json", "-o", "run", "--record", "states=run.states", "--quiet"};
        words.insert(words.end(), more.begin(), more.end());
        const RunResult result = run(words);
        ASSERT_EQ(result.code, 0) << result.err;
    }
    void expectSameFiles(const std::string& one, const std::string& other, size_t count)
    {
        const std::vector<std::string> names = listFolder(folder.path(one));
        EXPECT_EQ(names.size(), count);
        EXPECT_EQ(names, listFolder(folder.path(other)));
        for (const std::string& name : names)
            EXPECT_TRUE(readText(folder.path(one + "/" + name)) == readText(folder.path(other + "/" + name))) << name;
    }
};

TEST_F(States, AreDrawnAndExportedAsTheyWereInTheRun)
{
    record({"--export", "ply=run_ply", "--export", "bodies=run.csv", "--export", "gltf=run.glb", "--set",
            "objects.0.position.1=0.25"});
    const RunResult again = run({"render", "--from", "run.states", "-o", "again", "--export", "ply=again_ply",
                                 "--export", "bodies=again.csv", "--export", "gltf=again.glb"});
    ASSERT_EQ(again.code, 0) << again.err;
    EXPECT_TRUE(again.out.starts_with("4 frames of run.states drawn in ")) << again.out;
    expectSameFiles("run", "again", 4);
    expectSameFiles("run_ply", "again_ply", 4);
    EXPECT_EQ(readText(folder.path("run.csv")), readText(folder.path("again.csv")));
    EXPECT_TRUE(readText(folder.path("run.glb")) == readText(folder.path("again.glb")));
}

TEST_F(States, ShowAnyFrameByAnotherCamera)
{
    record();
    const std::vector<std::string> changes{"--set", "camera.position=[3,1,0]", "--size", "32x32", "--frames", "3"};
    std::vector<std::string> drawn{"render", "--from", "run.states", "-o", "drawn"};
    std::vector<std::string> simulated{"render", "tiny.json", "-o", "simulated"};
    for (std::vector<std::string>* words : {&drawn, &simulated}) {
        words->insert(words->end(), changes.begin(), changes.end());
        ASSERT_EQ(run(*words).code, 0);
    }
    expectSameFiles("drawn", "simulated", 1);
    EXPECT_NE(readText(folder.path("drawn/frame_0003.png")), readText(folder.path("run/frame_0003.png")));
}

TEST_F(States, FollowAsTheRunDidAlsoWithoutDrawingEarlierFrames)
{
    record({"--set", "camera={\"kind\":\"follow\",\"follow\":\"pair\"}"});
    ASSERT_EQ(run({"render", "--from", "run.states", "-o", "drawn", "--frames", "4:"}).code, 0);
    EXPECT_EQ(readText(folder.path("drawn/frame_0004.png")), readText(folder.path("run/frame_0004.png")));
}

TEST_F(States, AreTold)
{
    record({"--record-every", "2", "--save-state", "end.states"});
    const RunResult all = run({"info", "run.states"});
    ASSERT_EQ(all.code, 0) << all.err;
    EXPECT_NE(all.out.find("states of the scene \"tiny\""), std::string::npos) << all.out;
    EXPECT_NE(all.out.find("frames        1 to 4, "), std::string::npos) << all.out;
    EXPECT_NE(all.out.find("whole states  1, 3, 4, "), std::string::npos) << all.out;
    const RunResult end = run({"info", "end.states"});
    EXPECT_NE(end.out.find("frames        4, "), std::string::npos) << end.out;
    EXPECT_NE(end.out.find("whole states  4, "), std::string::npos) << end.out;
    EXPECT_NE(end.out.find("device        llvmpipe"), std::string::npos) << end.out;
}

TEST_F(States, AreNamedByTheFramesThatShowThem)
{
    record();
    const RunResult frame = run({"info", "run/frame_0003.png"});
    ASSERT_EQ(frame.code, 0) << frame.err;
    EXPECT_TRUE(frame.out.starts_with("run/frame_0003.png: 64 x 36 pixels, 8 bits a channel\n"));
    for (const char* line :
         {"  scene         tiny\n", "  frame         3\n", "  device        llvmpipe", "  program       knuckle "})
        EXPECT_NE(frame.out.find(line), std::string::npos) << frame.out;
    const RunResult hash = run({"render", "tiny.json", "-o", "run", "--frames", "3:3", "--hash", "--quiet"});
    const std::string printed = hash.out.substr(std::string("state hash ").size());
    EXPECT_NE(frame.out.find("  state hash    " + printed), std::string::npos) << frame.out << hash.out;
    writePng(folder.path("plain.png"), {2, 1, {1, 2, 3, 4, 5, 6}});
    EXPECT_EQ(run({"info", "plain.png"}).out,
              "plain.png: 2 x 1 pixels, 8 bits a channel\n  says nothing of where it comes from\n");
}

TEST_F(States, TellWhetherSimulatingOrDrawingDiffers)
{
    const auto compared = [&](const std::string& change) {
        EXPECT_EQ(run({"render", "tiny.json", "-o", "a", "--frames", "4", "-q"}).code, 0);
        EXPECT_EQ(run({"render", "tiny.json", "-o", "b", "--frames", "4", "-q", "--set", change}).code, 0);
        const RunResult result = run({"compare", "a/frame_0004.png", "b/frame_0004.png"});
        EXPECT_EQ(result.code, 4);
        return result.out;
    };
    const std::string drawn = compared("light.direction=[1,-1,0]"), simulated = compared("objects.0.position.1=0.6");
    EXPECT_NE(drawn.find("they are of the same state, so what was drawn differs\n"), std::string::npos) << drawn;
    EXPECT_NE(simulated.find("they are of different states, so what was simulated differs: "), std::string::npos)
        << simulated;
}

TEST_F(States, DoNotChangeTheRun)
{
    const auto hash = [&](std::vector<std::string> more) {
        std::vector<std::string> words{"render", "tiny.json", "-o", "out", "--hash", "--quiet"};
        words.insert(words.end(), more.begin(), more.end());
        return run(words).out;
    };
    EXPECT_EQ(hash({}), hash({"--record", "states=a.states", "--record-every", "1"}));
    // And are the same in each run.
    ASSERT_EQ(run({"render", "tiny.json", "-o", "out", "--record", "states=b.states", "--record-every", "1"}).code, 0);
    EXPECT_TRUE(readText(folder.path("a.states")) == readText(folder.path("b.states")));
}

TEST_F(States, HaveWhatTheRunShowed)
{
    record({"--set", "render.colorBy=contactForce"});
    ASSERT_EQ(run({"render", "--from", "run.states", "-o", "again"}).code, 0);
    expectSameFiles("run", "again", 4);
    EXPECT_EQ(run({"render", "--from", "run.states", "-o", "plain", "--set", "render.colorBy=body"}).code, 0);
    expectError(run({"render", "--from", "run.states", "-o", "ages", "--set", "render.colorBy=age"}), 2,
                "run.states: has no ages, which render.colorBy asks for and only a run that shows them records; choose "
                "another, or render the scene");
    folder.write("after.json", std::string(R"({ "start": { "from": "run.states" },)") + (TINY_SCENE + 1));
    expectError(run({"check", "after.json", "--set", "render.colorBy=age"}), 2,
                "after.json: /start/from: run.states has no ages, which /render/colorBy asks for; record it with the "
                "same, or choose another");
}

TEST_F(States, AreRefusedInOneLine)
{
    record();
    const auto refused = [&](std::vector<std::string> words, const std::string& message) {
        words.insert(words.begin(), "render");
        const RunResult result = run(words);
        expectError(result, 2, message);
    };
    refused({}, "SCENE is required, or --from; see knuckle render --help");
    refused({"--from", "no.states"}, "no.states: cannot be read: No such file or directory");
    refused({"--from", "tiny.json"}, "tiny.json: is not a file of states, as --record and --save-state write them");
    refused({"--from", "run.states", "--frames", "9"}, "--frames 9:9: run.states has frames 1 to 4; choose among them");
    refused({"--from", "run.states", "--set", "solver.substeps=7"},
            "run.states: is of another world than this scene, made of tiny.json: what is simulated must be the same; "
            "leave SCENE out to take it as it was, and change its picture with --set");
    refused({"--from", "run.states", "--fps", "30", "--set", "solver.timeStep=0.0166667"},
            "run.states: has 60 frames a second, the scene 30; set fps=60");
    refused({"--from", "run.states", "--export", "measures=m.csv"},
            "--export measures: run.states does not hold what they are measured from; export them in the run that "
            "simulates");
    refused({"--from", "run.states", "--hash"},
            "--from: nothing is simulated, so there is nothing to record, to measure or to go on with; leave out "
            "--record, --save-state, --stats, --hash, --checkpoint and --resume");
    refused({"tiny.json", "--record-every", "0"},
            "--record-every: 0 is out of range; give one from 1 to 1e+06; see knuckle --help");
    refused({"tiny.json", "--record", "states"}, "--record states: must be states=FILE");
    refused({"tiny.json", "--save-state", "end.png"},
            "--save-state end.png: a file of states is written as .states; name it so, or - for standard output");
    folder.write("cut.states", readText(folder.path("run.states")).substr(0, 500));
    refused({"--from", "cut.states"}, "cut.states: ends after 500 bytes, before its end mark; it was cut");
}

}  // namespace
}  // namespace knuckle::test
