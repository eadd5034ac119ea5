#include <sys/mount.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <thread>

#include "app/json/json.h"
#include "tests/cli/cli_fixture.h"
#include "tests/places.h"

namespace knuckle {
namespace {

namespace fs = std::filesystem;
using test::readText;
using test::RunOptions;
using test::RunResult;

/// `knuckle sweep` as typed.
class SweepCommand : public test::CliTest {
protected:
    /// Heights of the tiny scene's pair.
    static constexpr const char* FIELDS =
        R"("fields": [{"path": "objects.0.position.1", "values": [0.3, 0.4, 0.5, 0.6]}])";

    void writePlan(const std::string& more = FIELDS) const
    {
        folder.write("plan.json", R"({"scene": "tiny.json", "bodies": ["pair/body_1"], )" + more + "}");
    }
    RunResult sweep(std::vector<std::string> words, RunOptions options = {}) const
    {
        words.insert(words.begin(), {"-q", "sweep"});
        return run(words, std::move(options));
    }
    std::string table(const std::string& out) const
    {
        const RunResult result = sweep({"collect", "plan.json", "-o", out});
        EXPECT_EQ(result.code, 0) << result.err;
        return readText(folder.path(out + "/table.csv"));
    }
    /// With a program in place of Slurm's.
    RunOptions withSbatch(const std::string& script) const
    {
        fs::create_directory(folder.path("bin"));
        folder.write("bin/sbatch", "#!/bin/sh\n" + script);
        fs::permissions(folder.path("bin/sbatch"), fs::perms::owner_all);
        return {.environment = {"PATH=" + folder.path("bin") + ":/usr/bin:/bin"}};
    }
    /// The number of files of that beginning in the folders of runs.
    int countFiles(const std::string& out, const std::string& beginning) const
    {
        const std::vector<std::string> files = test::listFolder(folder.path(out));
        return static_cast<int>(std::ranges::count_if(
            files, [&](const std::string& file) { return fs::path(file).filename().string().starts_with(beginning); }));
    }
};

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

TEST_F(SweepCommand, KilledInTheMiddleGoesOnToTheSameBits)
{
    const std::string longer = R"("set": {"duration": 3}, "checkpoint": 0.05, )";
    writePlan(longer + FIELDS);
    ASSERT_EQ(sweep({"plan.json", "-o", "whole", "--jobs", "2"}).code, 0);
    const RunResult killed = sweep(
        {"plan.json", "-o", "killed", "--jobs", "2"},
        {.signalAfterFile = SIGKILL, .waitFor = folder.path("killed/run_0002/still.png.checkpoint/current.states")});
    EXPECT_EQ(killed.code, 1000 + SIGKILL);
    const RunResult status = run({"sweep", "status", "plan.json", "-o", "killed"});
    EXPECT_NE(status.out.find("left by process"), std::string::npos) << status.out;
    ASSERT_EQ(sweep({"plan.json", "-o", "killed"}).code, 0);
    EXPECT_EQ(table("killed"), table("whole"));
    EXPECT_GT(countFiles("killed", "claim."), 4);
    EXPECT_NE(readText(folder.path("killed/run_0002/log")).find("goes on after frame"), std::string::npos);
}

TEST_F(SweepCommand, StoppedHasItsCheckpointAndGoesOn)
{
    // Only a stop writes a checkpoint here.
    writePlan(R"("set": {"duration": 20, "fps": 300}, "checkpoint": 1000, "output": "f_####.png", )" +
              std::string(FIELDS));
    const RunResult stopped = sweep({"plan.json", "-o", "out"},
                                    {.signalAfterFile = SIGTERM, .waitFor = folder.path("out/run_0001/f_0100.png")});
    EXPECT_EQ(stopped.code, 130);
    EXPECT_EQ(stopped.err, "knuckle: stopped; what was finished is kept\n");
    const RunResult status = run({"sweep", "status", "plan.json", "-o", "out"});
    EXPECT_EQ(status.out, "plan: 4 runs in out\n  waiting        4\n") << "who was stopped has not failed";
    EXPECT_TRUE(fs::exists(folder.path("out/run_0001/f_####.png.checkpoint/current.states")));
}

TEST_F(SweepCommand, SignalledTogetherWithItsRunsHasTheirCheckpoints)
{
    // As Slurm does: the worker passes on what its run has got already, which must not end it at once. A frame of this
    // size takes longer than the worker waits with that.
    writePlan(R"("set": {"duration": 20, "render.width": 3840, "render.height": 2160}, "checkpoint": 1000,
                 "output": "f_####.png", )" +
              std::string(FIELDS));
    const std::string script = "cd " + folder.path() + "; " + test::programPath() +
                               " --device software sweep plan.json -o out >said 2>&1 & worker=$!; while [ ! -e " +
                               folder.path("out/run_0001/f_0002.png") +
                               " ]; do sleep 0.01; done; kill -TERM $worker $(pgrep -P $worker); wait $worker";
    EXPECT_EQ(WEXITSTATUS(std::system(script.c_str())), 130) << readText(folder.path("said"));
    EXPECT_TRUE(fs::exists(folder.path("out/run_0001/f_####.png.checkpoint/current.states")));
}

TEST_F(SweepCommand, WorkersAtOnceShareTheRuns)
{
    writePlan();
    std::vector<std::thread> workers;
    std::vector<RunResult> results(3);
    for (RunResult& result : results) workers.emplace_back([&] { result = sweep({"plan.json", "-o", "out"}); });
    for (std::thread& worker : workers) worker.join();
    for (const RunResult& result : results) EXPECT_EQ(result.code, 0) << result.err;
    EXPECT_EQ(countFiles("out", "claim."), 4) << "a run was done twice";
    EXPECT_EQ(std::ranges::count(table("out"), '\n'), 5);
}

TEST_F(SweepCommand, OfAnotherMachineIsTakenOverWhenItIsSilent)
{
    // Processes that do not see each other are as those of two machines.
    const std::string apart = "unshare --fork --pid --mount-proc --kill-child ";
    if (std::system((apart + "true 2>/dev/null").c_str()) != 0) GTEST_SKIP() << "only root can hide processes";
    writePlan(std::string(R"("set": {"duration": 3}, "checkpoint": 0.05, )") + FIELDS);
    const std::string script = "cd " + folder.path() + "; " + apart + test::programPath() +
                               " --device software sweep plan.json -o out >said 2>&1 & "
                               "while [ ! -e " +
                               folder.path("out/run_0002/still.png.checkpoint/current.states") +
                               " ]; do sleep 0.01; done; kill -9 $!; wait 2>/dev/null";
    static_cast<void>(std::system(script.c_str()));
    EXPECT_NE(run({"sweep", "status", "plan.json", "-o", "out"}).out.find("running by process"), std::string::npos);
    const RunResult other = sweep({"plan.json", "-o", "out", "--stale", "1"});
    EXPECT_EQ(other.code, 0) << other.err;
    EXPECT_EQ(countFiles("out", "claim."), 5) << "one was taken over";
    EXPECT_EQ(std::ranges::count(table("out"), '\n'), 5);
}

TEST_F(SweepCommand, ClaimsAreRenewedWhileTheirRunsGoOn)
{
    // A worker that sees no process of the first waits for it, however long its run takes.
    const std::string apart = "unshare --fork --pid --mount-proc ";
    if (std::system((apart + "true 2>/dev/null").c_str()) != 0) GTEST_SKIP() << "only root can hide processes";
    writePlan(R"("set": {"duration": 20}, "fields": [{"path": "fps", "values": [120]}])");
    std::thread first([&] {
        const std::string command = "cd " + folder.path() + " && " + apart + test::programPath() +
                                    " --device software sweep plan.json -o out --stale 1 >said 2>&1";
        EXPECT_EQ(std::system(command.c_str()), 0) << readText(folder.path("said"));
    });
    while (!fs::exists(folder.path("out/run_0001/claim.1"))) std::this_thread::yield();
    const auto claimed = fs::last_write_time(folder.path("out/run_0001/claim.1"));
    EXPECT_EQ(sweep({"plan.json", "-o", "out", "--stale", "1"}).code, 0);
    first.join();
    EXPECT_EQ(countFiles("out", "claim."), 1);
    const auto renewed = fs::last_write_time(folder.path("out/run_0001/claim.1"));
    EXPECT_GT(renewed - claimed, std::chrono::seconds(1)) << "the run takes longer than who is silent may be";
}

TEST_F(SweepCommand, FailedRunIsTriedAgainAndTold)
{
    writePlan(R"("fields": [{"path": "objects.0.position.1", "values": [0.3, 0.4]}])");
    fs::create_directories(folder.path("out/run_0002/bodies.csv"));  // no file can be put there
    const RunResult result = sweep({"plan.json", "-o", "out", "--tries", "2"});
    EXPECT_EQ(result.code, 1);
    EXPECT_NE(result.err.find("knuckle: run 2 failed with exit code 2: knuckle: "), std::string::npos) << result.err;
    EXPECT_NE(result.err.find("(try 1 of 2)"), std::string::npos);
    EXPECT_TRUE(result.err.ends_with("knuckle: 1 of 2 runs failed; `knuckle sweep status plan.json` says why, and the "
                                     "same command with more --tries tries them again\n"))
        << result.err;
    const RunResult status = run({"sweep", "status", "plan.json", "-o", "out", "--tries", "2"});
    EXPECT_NE(status.out.find("failed         1\nrun 2: failed 2 times: failed with exit code 2: knuckle: "),
              std::string::npos)
        << status.out;
    const RunResult collected = sweep({"collect", "plan.json", "-o", "out", "--tries", "2"});
    expectError(collected, 1,
                "1 of 2 runs missing in out/table.csv, 1 of them failed; `knuckle sweep status plan.json` says more");
    EXPECT_NE(readText(folder.path("out/table.csv")).find("\n2,0.4,,,"), std::string::npos);
    fs::remove(folder.path("out/run_0002/bodies.csv"));
    EXPECT_EQ(sweep({"plan.json", "-o", "out"}).code, 0) << "a third try";
    EXPECT_EQ(std::ranges::count(table("out"), '\n'), 3);
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

TEST_F(SweepCommand, FullStorageIsOneLineAndGoesOnWithRoom)
{
    fs::create_directory(folder.path("disk"));
    if (mount("tmpfs", folder.path("disk").c_str(), "tmpfs", 0, "size=160k") != 0)
        GTEST_SKIP() << "only root can make a small disk";
    writePlan(std::string(R"("set": {"duration": 2}, "output": "f_####.png", )") + FIELDS);
    const RunResult full = sweep({"plan.json", "-o", "disk/out", "--jobs", "2"});
    EXPECT_EQ(full.code, 1);
    EXPECT_TRUE(test::isOneLine(full.err)) << full.err;
    EXPECT_TRUE(full.err.ends_with("No space left on device; make room, then the same command goes on\n")) << full.err;
    mount("tmpfs", folder.path("disk").c_str(), "tmpfs", MS_REMOUNT, "size=64m");
    EXPECT_EQ(sweep({"plan.json", "-o", "disk/out", "--jobs", "2"}).code, 0);
    EXPECT_EQ(std::ranges::count(table("disk/out"), '\n'), 5);
    umount2(folder.path("disk").c_str(), MNT_DETACH);
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
