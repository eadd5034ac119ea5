#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "app/json/json.h"
#include "tests/cli/sweep/sweep_fixture.h"

namespace knuckle {
namespace {

namespace fs = std::filesystem;
using test::readText;
using test::RunOptions;
using test::RunResult;
using test::SweepCommand;

TEST_F(SweepCommand, MakesATableAndAPageOfAllRuns)
{
    writePlan();
    ASSERT_EQ(sweep({"plan.json", "--jobs", "2"}).code, 0);
    EXPECT_EQ(sweep({"collect", "plan.json"}).err, "");
    const std::string text = readText(folder.path("out/plan/table.csv"));
    EXPECT_TRUE(text.starts_with("run,objects.0.position.1,hash,contacts,worstPenetration,worstJointGap,maxSpeed,"
                                 "kineticEnergy,pair/body_1 x,pair/body_1 y,pair/body_1 z\n1,0.3,"))
        << text;
    EXPECT_EQ(std::ranges::count(text, '\n'), 5);
    // A run is what its command says.
    const Json done = Json::parse(readText(folder.path("out/plan/run_0003/done.json")));
    const RunResult alone = run({"-q", "render", "tiny.json", "--set", "objects.0.position.1=0.5", "--hash"});
    EXPECT_EQ(alone.out, "state hash " + done["hash"].get<std::string>() + "\n");
    EXPECT_NE(text.find("3,0.5," + done["hash"].get<std::string>()), std::string::npos);
    const std::string page = readText(folder.path("out/plan/index.html"));
    for (int k = 1; k <= 4; ++k) {
        const std::string picture = "run_000" + std::to_string(k) + "/still.png";
        EXPECT_NE(page.find("<img src=\"" + picture + "\""), std::string::npos);
        EXPECT_TRUE(fs::exists(folder.path("out/plan/" + picture)));
    }
    EXPECT_EQ(countFiles("out/plan", ".knuckle"), 0);
    EXPECT_EQ(countFiles("out/plan", "still.png.checkpoint"), 0);
}

TEST_F(SweepCommand, BadPlansAreOneLine)
{
    const auto refuse = [&](const std::string& plan, const std::string& message) {
        folder.write("plan.json", plan);
        expectError(sweep({"plan.json"}), 2, message);
        EXPECT_FALSE(fs::exists(folder.path("out")));
    };
    refuse(R"({"scene": "tiny.json", "runs": 3)",
           "plan.json:1:32: syntax error while parsing object - unexpected end of input; expected '}'");
    refuse(R"({"scene": "none.json"})", "plan.json: /scene: none.json: there is no such file");
    refuse(R"({"scene": "tiny.json", "fields": [{"path": "solver.substepz", "values": [1]}]})",
           "plan.json: /fields/0: tiny.json: /solver/substepz: unknown field; did you mean \"substeps\"?");
    refuse(R"({"scene": "tiny.json", "runs": 2, "fields": [{"path": "duration", "range": [1, 2e9]}]})",
           "plan.json: /fields/0: tiny.json: /duration: 2000000000.0 is above the maximum 3600 [s]");
    refuse(R"({"scene": "tiny.json", "bodies": ["pair/middle"]})",
           "plan.json: /bodies/0: \"pair/middle\" is no body of the scene; known: pair/body_1, pair/body_2");
    refuse(R"({"scene": "tiny.json", "exports": {"bvh": "a.csv"}})",
           "plan.json: /exports: --export bvh=a.csv: a motion as BVH is written as .bvh; name it so, or - for "
           "standard output");
    refuse(R"({"states": "none.states", "output": "film.mp4"})",
           "none.states: cannot be read: No such file or directory");
    expectError(sweep({}), 2, "PLAN is required; see knuckle sweep --help");
    writePlan();
    expectError(sweep({"status", "plan.json"}), 2,
                "folder out/plan has no runs of plan.json yet; `knuckle sweep plan.json` runs them, -o names another");
}

TEST_F(SweepCommand, RunsOfAnotherPlanAreNotMixed)
{
    writePlan();
    ASSERT_EQ(sweep({"plan.json", "-o", "out"}).code, 0);
    writePlan(R"("fields": [{"path": "objects.0.position.1", "values": [0.3, 0.4, 0.5, 0.7]}])");
    const std::string message = "folder out has runs of another plan, or plan.json or its scene has changed since; "
                                "give another one with -o, or "
                                "remove it";
    expectError(sweep({"plan.json", "-o", "out"}), 2, message);
    expectError(sweep({"collect", "plan.json", "-o", "out"}), 2, message);
}

TEST_F(SweepCommand, RecordedStatesAreDrawnInParts)
{
    ASSERT_EQ(run({"-q", "render", "tiny.json", "-o", "here", "--record", "states=r.states"}).code, 0);
    folder.write("plan.json", R"({"states": "r.states", "parts": 2, "output": "frame_####.png"})");
    ASSERT_EQ(sweep({"plan.json", "-o", "out"}).code, 0);
    EXPECT_TRUE(table("out").starts_with("run,frames,hash\n1,1:2,"));
    EXPECT_EQ(countFiles("out", "frame_"), 4) << "each frame once";
    for (const auto& [part, frame] : {std::pair{"run_0001", "frame_0001.png"}, {"run_0002", "frame_0004.png"}})
        EXPECT_EQ(readText(folder.path(std::string("out/") + part + "/" + frame)),
                  readText(folder.path(std::string("here/") + frame)));
}

TEST_F(SweepCommand, ShotsOfRecordedStatesAreRuns)
{
    ASSERT_EQ(run({"-q", "render", "tiny.json", "-o", "here", "--record", "states=r.states"}).code, 0);
    folder.write("plan.json", R"({"states": "r.states", "shots": true, "output": "frame_####.png",
        "set": {"shots": [{"from": 0}, {"from": 0.05}]}})");
    const RunResult result = sweep({"plan.json", "-o", "out"});
    ASSERT_EQ(result.code, 0) << result.err;
    const std::string text = table("out");
    EXPECT_NE(text.find("\n1,1:3,"), std::string::npos) << text;
    EXPECT_NE(text.find("\n2,4:4,"), std::string::npos) << text;
}

TEST_F(SweepCommand, SlurmGetsAScriptWithTheOptionsPassedOn)
{
    writePlan();
    const RunResult result = run({"sweep", "plan.json", "--slurm=--partition=long --time=1:00:00"},
                                 withSbatch("cp \"$2\" given\necho 42\n"));
    EXPECT_EQ(result.code, 0) << result.err;
    EXPECT_EQ(result.out, "4 runs as job 42 of Slurm; `knuckle sweep status plan.json` says how far they are\n");
    const std::string script = readText(folder.path("given"));
    EXPECT_NE(script.find("#SBATCH --array=1-4\n"), std::string::npos) << script;
    EXPECT_NE(script.find("#SBATCH --partition=long --time=1:00:00\nexec "), std::string::npos) << script;
    EXPECT_NE(script.find(" sweep " + folder.path("plan.json") + " -o " + folder.path("out/plan") + " --leave "),
              std::string::npos)
        << script;
    // Each task is such a line.
    EXPECT_EQ(std::system(("cd / && sh " + folder.path("given") + " >/dev/null 2>&1").c_str()), 0);
    EXPECT_EQ(std::ranges::count(table("out/plan"), '\n'), 5);
}

TEST_F(SweepCommand, WithoutSlurmLeavesTheScript)
{
    writePlan();
    const RunOptions options = withSbatch("echo 'sbatch: error: no partition' >&2\nexit 1\n");
    expectError(sweep({"plan.json", "--slurm", "--jobs", "2"}, options), 2,
                "--slurm: sbatch failed with exit code 1: sbatch: error: no partition; out/plan/sweep.sbatch is "
                "written, and can be submitted by hand");
    EXPECT_NE(readText(folder.path("out/plan/sweep.sbatch")).find("--array=1-2\n"), std::string::npos);
}

}  // namespace
}  // namespace knuckle
