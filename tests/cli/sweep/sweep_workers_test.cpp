#include <sys/mount.h>
#include <sys/wait.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <thread>

#include "tests/cli/sweep/sweep_fixture.h"
#include "tests/places.h"

namespace knuckle {
namespace {

namespace fs = std::filesystem;
using test::readText;
using test::RunResult;
using test::SweepCommand;

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

TEST_F(SweepCommand, LeavesWhatOthersWorkOn)
{
    writePlan(R"("set": {"duration": 20}, "fields": [{"path": "fps", "values": [120]}])");
    std::thread first([&] { EXPECT_EQ(sweep({"plan.json", "-o", "out", "--stale", "1"}).code, 0); });
    while (!fs::exists(folder.path("out/run_0001/claim.1"))) std::this_thread::yield();
    EXPECT_EQ(sweep({"plan.json", "-o", "out", "--leave"}).code, 0);
    EXPECT_FALSE(fs::exists(folder.path("out/run_0001/done.json"))) << "it has waited";
    first.join();
    EXPECT_EQ(countFiles("out", "claim."), 1);
}

TEST_F(SweepCommand, WithoutADeviceLeavesTheRunsToOthers)
{
    writePlan();
    const RunResult result = sweep({"plan.json", "-o", "out"},
                                   {.environment = {"__EGL_VENDOR_LIBRARY_FILENAMES=/none.json"}});
    if (result.code == 0) GTEST_SKIP() << "this driver ignores the variable";
    EXPECT_EQ(result.code, 3);
    EXPECT_TRUE(test::isOneLine(result.err)) << result.err;
    EXPECT_TRUE(result.err.ends_with("; other machines may go on\n")) << result.err;
    EXPECT_EQ(run({"sweep", "status", "plan.json", "-o", "out"}).out, "plan: 4 runs in out\n  waiting        4\n");
}

TEST_F(SweepCommand, FailedRunIsTriedAgainAndTold)
{
    writePlan(R"("fields": [{"path": "objects.0.position.1", "values": [0.3, 0.4]}])");
    fs::create_directories(folder.path("out/run_0002/bodies.csv"));  // no file can be put there
    const RunResult result = sweep({"plan.json", "-o", "out", "--tries", "2"});
    EXPECT_EQ(result.code, 1);
    EXPECT_NE(result.err.find("knuckle: run 2 failed with exit code 2: out/run_0002/bodies.csv"), std::string::npos)
        << result.err;
    EXPECT_NE(result.err.find("(try 1 of 2)"), std::string::npos);
    EXPECT_TRUE(result.err.ends_with("knuckle: 1 of 2 runs failed; `knuckle sweep status plan.json` says why, and the "
                                     "same command with more --tries tries them again\n"))
        << result.err;
    const RunResult status = run({"sweep", "status", "plan.json", "-o", "out", "--tries", "2"});
    EXPECT_NE(
        status.out.find("failed         1\nrun 2: failed 2 times: failed with exit code 2: out/run_0002/bodies.csv"),
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

}  // namespace
}  // namespace knuckle
