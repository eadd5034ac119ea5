#include <filesystem>

#include "render/picture/image.h"
#include "tests/cli/golden/golden_fixture.h"

namespace knuckle::test {
namespace {

namespace fs = std::filesystem;

TEST_F(GoldenTest, IsEqualToWhatMadeIt)
{
    add();
    EXPECT_EQ(listFolder(folder.path("golden")),
              (std::vector<std::string>{"tiny", "tiny/frame_0001@llvmpipe.png", "tiny/frame_0004@llvmpipe.png",
                                        "tiny/golden.json", "tiny/states@llvmpipe.states"}));
    const RunResult result = check();
    EXPECT_EQ(result.code, 0) << result.out << result.err;
    EXPECT_EQ(result.out, "1 golden: 0 of 2 states and 0 of 2 pictures differ\n");
    EXPECT_EQ(result.err, "");
    for (const char* threads : {"LP_NUM_THREADS=0", "LP_NUM_THREADS=2", "LP_NATIVE_VECTOR_WIDTH=128"})
        EXPECT_EQ(run({"golden", "check"}, {.environment = {threads}}).out, result.out) << threads;
    // The pictures are those of the film.
    ASSERT_EQ(run({"render", "tiny.json", "-o", "out", "--size", "96x54", "-q"}).code, 0);
    EXPECT_EQ(run({"compare", "out/frame_0004.png", "golden/tiny/frame_0004@llvmpipe.png", "--threshold", "0",
                   "--max-pixels", "0"})
                  .code,
              0);
}

TEST_F(GoldenTest, TellsPhysicsFromDrawing)
{
    add();
    const RunResult drawn = check({"--set", "light.direction=[-0.2,0.85,0.6]"});
    EXPECT_EQ(drawn.code, 4);
    EXPECT_TRUE(has(drawn, "tiny/frame_0001: drawing: different: ")) << drawn.out;
    EXPECT_TRUE(has(drawn, "the difference is in ")) << drawn.out;
    EXPECT_FALSE(has(drawn, "physics")) << drawn.out;
    EXPECT_TRUE(has(drawn, "0 of 2 states and 2 of 2 pictures differ\n")) << drawn.out;
    const RunResult moved = check({"--set", "solver.gravity=[0,-9.7,0]"});
    EXPECT_EQ(moved.code, 4);
    EXPECT_TRUE(has(moved, "tiny/frame_0004: physics: different: ")) << moved.out;
    EXPECT_FALSE(has(moved, "frame_0001")) << moved.out;
    EXPECT_FALSE(has(moved, "drawing")) << moved.out;
    EXPECT_TRUE(has(moved, "1 of 2 states and 0 of 2 pictures differ\n")) << moved.out;
}

TEST_F(GoldenTest, TellsHowFarParticlesAre)
{
    add();
    // Pairs of the scene have a diameter of 0.1 m: 0.05 m are half of one.
    const RunResult moved = check({"--states", "--set", "objects.0.position=[0.05,0.3,0]"});
    EXPECT_EQ(moved.code, 4);
    EXPECT_TRUE(has(moved, "more than 0.0034 diameters from where they were, most of \"pair\" (")) << moved.out;
    EXPECT_TRUE(has(moved, "; the farthest, particle ")) << moved.out;
    EXPECT_TRUE(has(moved, " of \"pair\", by 0.5 diameters, at ")) << moved.out;
    edit("golden/tiny/golden.json", "\"recorded\"", "\"states\": { \"distance\": 0.51 }, \"recorded\"");
    EXPECT_EQ(check({"--states", "--set", "objects.0.position=[0.05,0.3,0]"}).code, 0);
    EXPECT_EQ(check({"--states", "--set", "objects.0.position=[0.06,0.3,0]"}).code, 4);
}

TEST_F(GoldenTest, TellsThatTheSceneHasOtherParticles)
{
    add();
    edit("tiny.json", "}],\n        \"render\"",
         "},\n{ \"type\": \"rigid\", \"shape\": \"sphere\", \"radius\": 0.2 }],\n\"render\"");
    const RunResult result = check();
    EXPECT_EQ(result.code, 4) << result.out;
    EXPECT_TRUE(has(result, "physics: different: it has ")) << result.out;
    EXPECT_TRUE(has(result, "drawing: different: the stored state cannot be drawn: the scene has ")) << result.out;
    EXPECT_TRUE(has(result, " bodies, not 2\n")) << result.out;
}

TEST_F(GoldenTest, UpdateWritesOnlyWhatFailed)
{
    add();
    const std::string first = folder.path("golden/tiny/frame_0001@llvmpipe.png"),
                      last = folder.path("golden/tiny/frame_0004@llvmpipe.png");
    const auto before = fs::last_write_time(first);
    const RunResult nothing = run({"golden", "update"});
    EXPECT_EQ(nothing.out, "0 of 1 goldens written anew\n") << nothing.err;
    edit("tiny.json", "[0, 0.3, 0]", "[0, 0.3, 0], \"velocity\": [0, -1, 0]");
    const RunResult result = run({"golden", "update"});
    EXPECT_EQ(result.code, 0) << result.err;
    EXPECT_TRUE(has(result, "tiny: accepts frame_0004: physics: different: ")) << result.out;
    EXPECT_TRUE(has(result, "1 of 1 goldens written anew\n")) << result.out;
    EXPECT_EQ(check().code, 0);
    // Its velocity differs from the first frame on, its places do not.
    EXPECT_TRUE(has(result, "frame_0001: physics: different: bits differ, of velocities or by roundings"))
        << result.out;
    EXPECT_GE(fs::last_write_time(first), before);
    writePng(last, {96, 54, std::vector<uint8_t>(size_t{96} * 54 * 3)});
    const auto states = fs::last_write_time(folder.path(STATES));
    const RunResult drawn = run({"golden", "update"});
    EXPECT_TRUE(has(drawn, "tiny: wrote frame_0004@llvmpipe.png, golden.json\n")) << drawn.out;
    EXPECT_EQ(fs::last_write_time(folder.path(STATES)), states);
    EXPECT_EQ(check().code, 0);
}

TEST_F(GoldenTest, OfAnotherDriverIsNamedAndAdvisory)
{
    add();
    pretendOtherDriver();
    const RunResult same = check();
    EXPECT_EQ(same.code, 0);
    EXPECT_TRUE(has(same, "no references of llvmpipe")) << same.out;
    EXPECT_TRUE(has(same, ": compared with those of llvmpipe\n")) << same.out;
    const RunResult moved = check({"--set", "solver.gravity=[0,-9.7,0]"});
    EXPECT_EQ(moved.code, 0);
    EXPECT_TRUE(has(moved, "advisory: tiny/frame_0004: physics: different: ")) << moved.out;
    EXPECT_TRUE(has(moved, ", 1 difference advisory\n")) << moved.out;
    // Pictures are drawn from stored states, and count.
    EXPECT_EQ(check({"--set", "render.exposure=1.2"}).code, 4);
    edit("golden/tiny/golden.json", "\"recorded\"",
         "\"elsewhere\": { \"states\": \"fail\", \"pictures\": \"advisory\" }, \"recorded\"");
    EXPECT_EQ(check({"--set", "solver.gravity=[0,-9.7,0]"}).code, 4);
    EXPECT_EQ(check({"--set", "render.exposure=1.2"}).code, 0);
}

TEST_F(GoldenTest, UpdateRefusesAnotherDriverUnlessTold)
{
    add();
    pretendOtherDriver();
    const RunResult refused = run({"golden", "update"});
    EXPECT_EQ(refused.code, 2);
    EXPECT_NE(refused.err.find("golden/tiny/golden.json: its references are of llvmpipe"), std::string::npos);
    EXPECT_NE(refused.err.find("--other-driver beside keeps both, --other-driver replace only these\n"),
              std::string::npos)
        << refused.err;
    EXPECT_TRUE(isOneLine(refused.err));
    ASSERT_EQ(run({"golden", "update", "--other-driver", "beside"}).code, 0);
    const std::vector<std::string> files = listFolder(folder.path("golden/tiny"));
    EXPECT_EQ(files.size(), 7u);
    EXPECT_TRUE(files[1].starts_with("frame_0001@llvmpipe.png") || files[0].starts_with("frame_0001@llvmpipe-"));
    const RunResult own = check();
    EXPECT_EQ(own.code, 0);
    EXPECT_FALSE(has(own, "no references of")) << own.out;
}

TEST_F(GoldenTest, ThatIsDamagedIsToldInOneLineEach)
{
    add();
    const std::string states = readText(folder.path(STATES));
    folder.write(STATES, states.substr(0, states.size() / 2));
    const RunResult cut = check();
    EXPECT_EQ(cut.code, 2);
    EXPECT_NE(cut.err.find("knuckle: tiny: golden/tiny/states@llvmpipe.states: "), std::string::npos) << cut.err;
    EXPECT_TRUE(isOneLine(cut.err)) << cut.err;
    fs::remove(folder.path(STATES));
    EXPECT_TRUE(isOneLine(check().err));
    folder.write(STATES, states);
    fs::remove(folder.path("golden/tiny/frame_0004@llvmpipe.png"));
    const RunResult gone = check();
    EXPECT_EQ(gone.code, 2);
    EXPECT_TRUE(gone.err.starts_with("knuckle: tiny/frame_0004: drawing: ")) << gone.err;
    EXPECT_TRUE(isOneLine(gone.err)) << gone.err;
    ASSERT_EQ(run({"golden", "update", "-q"}).code, 0);
    EXPECT_EQ(check().code, 0);
}

TEST_F(GoldenTest, RefusesWrongInput)
{
    const auto refused = [&](const std::vector<std::string>& words, const std::string& message) {
        expectError(run(words), 2, message);
    };
    refused({"golden", "check"}, "no folder golden here; name the folder of the goldens");
    refused({"golden", "check", "nowhere"}, "no folder nowhere; name the folder of the goldens first");
    fs::create_directory(folder.path("empty"));
    refused({"golden", "check", "empty"}, "no golden.json in empty or below; `knuckle golden add` makes one");
    add();
    refused({"golden", "check", "tyni"}, "no golden tyni in golden; did you mean \"tiny\"?");
    refused({"golden", "add", "tiny.json"},
            "golden/tiny/golden.json is there already; `knuckle golden update` makes its "
            "references anew, --name gives another name");
    refused({"golden", "add", "tiny.json", "--name", "other", "--frames", "5"},
            "--frames 5: 5 must be first, middle, last or a number from 1 to 4");
    refused({"golden", "check", "--states", "--pictures"},
            "--states and --pictures leave nothing out together; leave out one, or both");
    const std::string path = "golden/tiny/golden.json";
    const auto broken = [&](const std::string& message) {
        expectError(run({"golden", "check", "-q"}), 2, "tiny: " + message);
    };
    edit(path, "\"frames\"", "\"framse\"");
    broken(path + ": /framse: unknown field; did you mean \"frames\"?");
    edit(path, "\"framse\": [\n    1,\n    4", "\"frames\": [\n    4,\n    1");
    broken(path + ": /frames: must be in order, each frame once");
    edit(path, "\n    4,\n    1", "\n    1,\n    9");
    const RunResult late = check();
    EXPECT_EQ(late.code, 2);
    EXPECT_EQ(late.err, "knuckle: tiny: golden/tiny/golden.json: /frames: 9 is beyond the scene's last frame, 4; name "
                        "others\n");
    edit(path, "\"llvmpipe\": {", "\"../up\": {");
    broken(path + ": /recorded: \"../up\" must have only letters, digits, - and .");
    edit(path, "{", "{ \"images\": [\"a.png\"],");
    broken(path + ": /: must have either \"scene\" or \"images\"");
}

TEST_F(GoldenTest, SeesCollidersThatNothingTouches)
{
    edit("tiny.json", "{ \"type\": \"plane\" }",
         "{ \"type\": \"plane\" }, { \"type\": \"box\", \"size\": [0.2, 0.2, 0.2], \"position\": [2, 1, 0] }");
    add();
    const RunResult moved = check({"--states", "--set", "colliders.1.position=[2,1.05,0]"});
    EXPECT_EQ(moved.code, 4);
    EXPECT_TRUE(has(moved, "tiny/frame_0001: physics: different: particles have the same bits; a collider is 0.5 "
                           "diameters from where it was\n"))
        << moved.out;
    EXPECT_TRUE(has(check({"--states", "--set", "colliders.1.rotation=[0,5,0]"}), "; a collider is turned by 5"));
    EXPECT_TRUE(has(check({"--set", "colliders=[{\"type\":\"plane\"}]"}), "1 colliders, not 2")) << "gone";
    edit("golden/tiny/golden.json", "\"recorded\"", "\"states\": { \"distance\": 0.51 }, \"recorded\"");
    EXPECT_EQ(check({"--states", "--set", "colliders.1.position=[2,1.05,0]"}).code, 0);
}

TEST_F(GoldenTest, UpdateDrawsAllPicturesOfNewStates)
{
    add();
    // The first frame is within the limit, the last is not: with the states of both, both pictures are made anew.
    edit("golden/tiny/golden.json", "\"recorded\"", "\"states\": { \"distance\": 0.3 }, \"recorded\"");
    edit("tiny.json", "[0, 0.3, 0]", "[0.02, 0.3, 0], \"velocity\": [2, 0, 0]");
    const RunResult result = run({"golden", "update"});
    EXPECT_TRUE(has(result, "wrote frame_0001@llvmpipe.png, frame_0004@llvmpipe.png, states@")) << result.out;
    EXPECT_EQ(check().out, "1 golden: 0 of 2 states and 0 of 2 pictures differ\n");
}

TEST_F(GoldenTest, OfWhichOneIsBrokenLeavesTheOthers)
{
    add();
    add({"--name", "sound"});
    folder.write("golden/tiny/golden.json", "{");
    const RunResult result = check({"--json"});
    EXPECT_EQ(result.code, 2);
    EXPECT_TRUE(isOneLine(result.err)) << result.err;
    EXPECT_TRUE(has(result, "\"verdict\": \"unreadable\"")) << result.out;
    EXPECT_TRUE(has(check(), "2 goldens: 0 of 2 states and 0 of 2 pictures differ, 1 cannot be checked\n"));
    const RunResult update = run({"golden", "update", "--all"});
    EXPECT_EQ(update.code, 2);
    EXPECT_TRUE(has(update, "1 of 2 goldens written anew\n")) << update.out;
}

TEST_F(GoldenTest, KnowsStatesOfAnUpdateThatWasBrokenOff)
{
    add();
    const std::string before = readText(folder.path("golden/tiny/golden.json"));
    edit("tiny.json", "[0, 0.3, 0]", "[0, 0.35, 0]");
    ASSERT_EQ(run({"golden", "update", "-q"}).code, 0);
    folder.write("golden/tiny/golden.json", before);
    const RunResult result = check({"-q"});
    EXPECT_EQ(result.code, 2);
    EXPECT_NE(
        result.err.find("states@llvmpipe.states: is damaged, or not the file that golden.json was written with; "),
        std::string::npos)
        << result.err;
}

TEST_F(GoldenTest, WritesAReportForPeopleAndPrograms)
{
    add();
    const RunResult result = check({"--set", "solver.gravity=[0,-9,0]", "--set", "light.direction=[-0.2,0.85,0.6]",
                                    "--report", "report.html", "--junit", "report.xml", "--json"});
    EXPECT_EQ(result.code, 4) << result.err;
    for (const char* words : {"\"verdict\": \"different\"", "\"reference\": \"llvmpipe\"", "\"kind\": \"physics\"",
                              "\"moved\": ", "\"kind\": \"drawing\"", "\"flip\": "})
        EXPECT_TRUE(has(result, words)) << words;
    const std::string page = readText(folder.path("report.html")), junit = readText(folder.path("report.xml"));
    for (const char* words : {"tiny/frame_0004 physics", "tiny/frame_0001 drawing", "knuckle golden update golden/tiny",
                              "reference of", "this run&#39;s device", "data:image/png;base64"})
        EXPECT_NE(page.find(words), std::string::npos) << words;
    EXPECT_NE(junit.find("tests=\"4\" failures=\"3\" errors=\"0\""), std::string::npos) << junit;
    EXPECT_EQ(check({"--report", "golden/tiny/golden.json"}).code, 2);
}

TEST_F(GoldenTest, SuggestsLimitsFromWhatMakesNoDifference)
{
    add();
    const RunResult result = run({"golden", "suggest", "--repeats", "1", "--write"});
    ASSERT_EQ(result.code, 0) << result.err;
    EXPECT_TRUE(has(result, "tiny: pictures differed by: mean 0")) << result.out;
    EXPECT_TRUE(has(result, "checks could run: repeats, threads, widths of vectors, drivers\n")) << result.out;
    EXPECT_NE(readText(folder.path("golden/tiny/golden.json")).find("\"tile\": 0.25"), std::string::npos);
    EXPECT_EQ(check().code, 0);
    EXPECT_EQ(check({"--set", "render.exposure=1.01"}).code, 4);
}

}  // namespace
}  // namespace knuckle::test
