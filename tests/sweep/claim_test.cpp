#include "app/sweep/claim.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <set>

#include "app/sweep/run_folder.h"
#include "tests/temp_folder.h"

namespace knuckle {
namespace {

namespace fs = std::filesystem;

class SweepClaim : public testing::Test {
protected:
    /// What a worker finds there now. @param self who looks.
    RunStanding look(const Worker& self = Worker::self(), double stale = 100.0) const
    {
        return run.look({.self = self, .staleSeconds = stale, .tries = 2, .now = storedNow(folder.path())});
    }
    /// One that sees no process of this machine.
    static Worker elsewhere()
    {
        Worker worker = Worker::self();
        worker.host = "elsewhere";
        worker.place = "another start";
        return worker;
    }
    /// As if a claim had been renewed so long ago [s].
    void makeOlder(uint64_t claim, int seconds) const
    {
        const std::string path = claimPath(folder.path(), claim);
        fs::last_write_time(path, fs::last_write_time(path) - std::chrono::seconds(seconds));
    }

    test::TempFolder folder;
    RunFolder run{folder.path()};
};

TEST_F(SweepClaim, IsOfOneOnlyHoweverManyTryAtOnce)
{
    // Eight processes that all try to take two hundred things.
    constexpr int PROCESSES = 8, THINGS = 200;
    for (int thing = 0; thing < THINGS; ++thing) fs::create_directory(folder.path(std::to_string(thing)));
    std::vector<pid_t> children;
    for (int k = 0; k < PROCESSES; ++k) {
        children.push_back(fork());
        if (children.back() != 0) continue;
        const Worker self = Worker::self();
        while (!fs::exists(folder.path("go"))) continue;
        int taken = 0;
        for (int thing = 0; thing < THINGS; ++thing)
            if (Claim::take(folder.path(std::to_string(thing)), 1, self)) ++taken;
        folder.write("taken." + std::to_string(k), std::to_string(taken));
        _exit(0);
    }
    folder.write("go", "");
    int sum = 0;
    for (int k = 0; k < PROCESSES; ++k) {
        waitpid(children[k], nullptr, 0);
        sum += std::stoi(test::readText(folder.path("taken." + std::to_string(k))));
    }
    EXPECT_EQ(sum, THINGS);
}

TEST_F(SweepClaim, OnThisMachineIsLeftWhenItsProcessHasGone)
{
    EXPECT_EQ(look().stage, RunStage::Waiting);
    const pid_t child = fork();
    if (child == 0) {
        const bool taken = Claim::take(folder.path(), 1, Worker::self()).has_value();
        folder.write("ready", taken ? "yes" : "no");
        pause();
    }
    while (test::readText(folder.path("ready")).empty()) usleep(1000);
    makeOlder(1, 1000);
    EXPECT_EQ(look().stage, RunStage::Running) << "a process that is there works, however slowly";
    kill(child, SIGKILL);
    siginfo_t info = {};
    waitid(P_PID, static_cast<id_t>(child), &info, WEXITED | WNOWAIT);
    EXPECT_EQ(look().stage, RunStage::Left) << "not buried yet";
    waitpid(child, nullptr, 0);
    EXPECT_EQ(look().stage, RunStage::Left);
}

TEST_F(SweepClaim, OfAProcessWhoseNumberIsUsedAgainIsLeft)
{
    Worker other = Worker::self();
    other.started += "0";
    ASSERT_TRUE(Claim::take(folder.path(), 1, other));
    EXPECT_EQ(look().stage, RunStage::Left);
}

TEST_F(SweepClaim, ElsewhereIsLeftWhenItIsNotRenewed)
{
    const std::optional<Claim> claim = Claim::take(folder.path(), 1, elsewhere());
    ASSERT_TRUE(claim);
    EXPECT_EQ(look().stage, RunStage::Running);
    makeOlder(1, 50);
    EXPECT_EQ(look().stage, RunStage::Running);
    EXPECT_EQ(look(Worker::self(), 40.0).stage, RunStage::Left);
    makeOlder(1, 60);
    EXPECT_EQ(look().stage, RunStage::Left);
    EXPECT_TRUE(claim->renew());
    EXPECT_EQ(look().stage, RunStage::Running);
    EXPECT_NEAR(look().claim->age, 0.0, 5.0);
}

TEST_F(SweepClaim, ThatWasTakenOverIsSeenByWhoComesBack)
{
    const std::optional<Claim> first = Claim::take(folder.path(), 1, elsewhere());
    makeOlder(1, 1000);
    ASSERT_EQ(look().stage, RunStage::Left);
    const std::optional<Claim> second = Claim::take(folder.path(), look().claims + 1, Worker::self());
    ASSERT_TRUE(second);
    EXPECT_FALSE(Claim::take(folder.path(), 2, elsewhere())) << "taken over twice";
    EXPECT_FALSE(first->renew());
    EXPECT_TRUE(second->renew());
    EXPECT_EQ(look().stage, RunStage::Running);
    EXPECT_EQ(look().claim->worker, Worker::self());
}

TEST_F(SweepClaim, WithoutWordsIsLeftByItsAge)
{
    // Its process ended between making and writing it.
    folder.write("claim.1", "");
    EXPECT_EQ(look().stage, RunStage::Running);
    makeOlder(1, 1000);
    EXPECT_EQ(look().stage, RunStage::Left);
}

TEST_F(SweepClaim, IsTriedAgainAsOftenAsItMayFail)
{
    for (uint64_t number = 1; number <= 3; ++number) {
        ASSERT_TRUE(Claim::take(folder.path(), number, Worker::self()));
        run.end(number, {.failed = number != 2, .line = "line " + std::to_string(number)});
        const RunStanding standing = look();
        EXPECT_EQ(standing.stage, number < 3 ? RunStage::Waiting : RunStage::Failed)
            << "who was stopped has not failed";
        EXPECT_EQ(standing.failures, number < 3 ? 1u : 2u);
        EXPECT_EQ(standing.line, number < 3 ? "line 1" : "line 3");
    }
    folder.write("done.json", "{}");
    EXPECT_EQ(look().stage, RunStage::Done);
}

TEST_F(SweepClaim, LogsEndWithTheirLastLine)
{
    EXPECT_EQ(run.lastLogLine(), "");
    folder.write("log", "a\n" + std::string(10000, 'b') + "\nknuckle: disk full\n\n");
    EXPECT_EQ(run.lastLogLine(), "knuckle: disk full");
}

}  // namespace
}  // namespace knuckle
