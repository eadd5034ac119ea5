#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <map>
#include <memory>
#include <set>
#include <thread>

#include "app/run/counted.h"
#include "app/run/exit_codes.h"
#include "app/run/interrupt.h"
#include "app/run/progress.h"
#include "app/run/shell_command.h"
#include "app/run/stopwatch.h"
#include "app/run/tell.h"
#include "app/sweep/child.h"
#include "app/sweep/run_result.h"
#include "sim/base/cores.h"
#include "sim/base/errors.h"
#include "sim/base/files/leftovers.h"
#include "sim/base/files/output_file.h"
#include "sim/gpu/device/driver_threads.h"

namespace knuckle {

namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds POLL = 20ms, LOOK = 500ms;
/// A signal for this process may be meant for its children as well, and reach them at another moment.
constexpr std::chrono::milliseconds SIGNALS_APART = 200ms;

/// Before what the program tells.
constexpr const char* OUR_NAME = "knuckle: ";

/// A run that this process has claimed.
struct Job {
    const SweepRun* run;
    Claim claim;
    uint64_t failures = 0;  ///< Before.
    pid_t child = -1;
    std::unique_ptr<Leftover> leftover = {};  ///< Of the child, should this process be ended at once.
    Clock::time_point start = Clock::now();
};

/// Whether a run's last words are that there is no room: nothing that it or another run tries would help.
bool isOfNoRoom(const std::string& said)
{
    return std::ranges::any_of(std::array{ENOSPC, EDQUOT},
                               [&](int error) { return said.find(std::strerror(error)) != std::string::npos; });
}

class Work {
public:
    Work(const Sweep& sweep, const SweepOptions& options, const CommonOptions& common)
        : sweep_(sweep), options_(options), common_(common), watch_(options.watch),
          progress_("run", sweep.runs.size(), common.quiet)
    {
        for (const SweepRun& run : sweep.runs) open_.insert(&run);
    }

    void run()
    {
        try {
            while (!jobs_.empty() || !isOver()) {
                interrupt_.check();
                while (jobs_.size() < options_.jobs && startNext()) continue;
                reap();
                renewClaims();
                std::this_thread::sleep_for(POLL);
            }
        } catch (...) {
            stop();
            throw;
        }
        if (failed_ > 0)
            throw RunError(fmt::format("{} of {} failed; `knuckle sweep status {}` says why, and the same command with "
                                       "more --tries tries them again",
                                       failed_, counted(sweep_.runs.size(), "run"), sweep_.plan.path));
    }

    size_t doneCount() const { return done_; }

private:
    /// Claims and starts a run. @returns false if none is free, which is not asked again for some time.
    bool startNext()
    {
        if (Clock::now() < look_) return false;
        watch_.now = storedNow(sweep_.folder);
        for (auto next = open_.begin(); next != open_.end();) {
            const SweepRun& run = **next;
            const bool ours = std::ranges::any_of(jobs_, [&](const Job& job) { return job.run == &run; });
            const RunStanding state = ours ? RunStanding{.stage = RunStage::Running}
                                           : sweep_.folderOf(run).look(watch_);
            if (state.stage == RunStage::Done || state.stage == RunStage::Failed) {
                (state.stage == RunStage::Done ? done_ : failed_) += 1;
                next = open_.erase(next);
                continue;
            }
            if (state.claim) note(run, *state.claim);
            if (state.stage != RunStage::Running && start(run, state)) return true;
            ++next;
        }
        look_ = Clock::now() + LOOK;
        return false;
    }

    /// Remembers claims of others, and which of them have been renewed since they were first seen.
    void note(const SweepRun& run, const ClaimSeen& claim)
    {
        const auto [first, isNew] = seen_.try_emplace(run.number, claim.renewed);
        if (!isNew && first->second != claim.renewed) alive_.insert(run.number);
    }

    /// @returns false if another was faster.
    bool start(const SweepRun& run, const RunStanding& state)
    {
        const RunFolder folder = sweep_.folderOf(run);
        requireWritableFolder(folder.path());
        std::optional<Claim> claim = Claim::take(folder.path(), state.claims + 1, watch_.self);
        if (!claim) return false;
        const std::vector<std::string> words = runCommand(sweep_, run, common_);
        std::string line;
        for (const std::string& word : words) line += (line.empty() ? "" : " ") + quotedForShell(word);
        writeFile(folder.file("command"), line + "\n");
        Job job{&run, std::move(*claim), state.failures};
        job.child = startChild(words, folder.log());
        job.leftover = std::make_unique<Leftover>(job.child);
        jobs_.push_back(std::move(job));
        return true;
    }

    /// Ends what children have left.
    void reap()
    {
        for (auto job = jobs_.begin(); job != jobs_.end();) {
            int status = 0;
            if (waitpid(job->child, &status, WNOHANG) != job->child) {
                ++job;
                continue;
            }
            Job ended = std::move(*job);
            ended.leftover.reset();
            job = jobs_.erase(job);
            end(ended, status);
        }
    }

    void end(const Job& job, int status)
    {
        if (!job.claim.renew()) return;  // another has it now
        look_ = {};
        const std::string failure = failureOf(status);
        if (!failure.empty()) return endUndone(job, failure, WIFEXITED(status) ? WEXITSTATUS(status) : -1);
        try {
            const double seconds = std::chrono::duration<double>(Clock::now() - job.start).count();
            finishRun(sweep_, *job.run, watch_.self.host, seconds);
        } catch (const InputError& error) {
            return endFailed(job, error.what());
        }
        open_.erase(job.run);
        progress_.update(++done_);
    }

    void endUndone(const Job& job, const std::string& failure, int code)
    {
        const RunFolder folder = sweep_.folderOf(*job.run);
        if (code == EXIT_INTERRUPTED) std::this_thread::sleep_for(SIGNALS_APART);
        const bool stopped = code == EXIT_INTERRUPTED && (isStopping_ || interrupt_.isSignalled());
        std::string said = folder.lastLogLine();
        if (said.starts_with(OUR_NAME)) said.erase(0, std::string_view(OUR_NAME).size());
        const std::string line = said.empty() ? failure : failure + ": " + said;
        if (stopped || code == EXIT_DEVICE) folder.end(job.claim.number(), {.failed = false, .line = line});
        if (stopped) return;
        if (code == EXIT_DEVICE)
            throw DeviceError(fmt::format("run {}: {}; other machines may go on", job.run->number, said));
        requireRoom(sweep_.folder);
        if (isOfNoRoom(said)) {
            folder.end(job.claim.number(), {.failed = false, .line = line});
            throw RunError(fmt::format("run {}: {}; make room, then the same command goes on", job.run->number, said));
        }
        endFailed(job, line);
    }

    void endFailed(const Job& job, const std::string& line)
    {
        sweep_.folderOf(*job.run).end(job.claim.number(), {.failed = true, .line = line});
        tellUser(
            fmt::format("knuckle: run {} {} (try {} of {})", job.run->number, line, job.failures + 1, watch_.tries));
    }

    /// Whether nothing is left to do or, for who does not wait, all of it is seen in hands of others.
    bool isOver() const
    {
        return open_.empty() || (options_.leave && std::ranges::all_of(open_, [&](const SweepRun* run) {
                                     return alive_.contains(run->number);
                                 }));
    }

    /// Children of who was taken for dead are ended: another does their work.
    void renewClaims()
    {
        const double interval = std::min(30.0, watch_.staleSeconds / 4.0);
        if (std::chrono::duration<double>(Clock::now() - renewed_).count() < interval) return;
        renewed_ = Clock::now();
        for (const Job& job : jobs_)
            if (!job.claim.renew()) stopChild(job.child);
    }

    /// Lets all children write their checkpoints and end.
    void stop()
    {
        std::this_thread::sleep_for(SIGNALS_APART);
        for (const Job& job : jobs_) stopChild(job.child);
        isStopping_ = true;
        while (!jobs_.empty()) {
            try {
                reap();
            } catch (const std::exception&) {
                // What stops this process is told already; claims without an end are taken over without it.
            }
            std::this_thread::sleep_for(POLL);
        }
    }

    /// In the order of their numbers.
    struct ByNumber {
        bool operator()(const SweepRun* a, const SweepRun* b) const { return a->number < b->number; }
    };

    const Sweep& sweep_;
    const SweepOptions& options_;
    const CommonOptions& common_;
    Watch watch_;
    const InterruptGuard interrupt_;
    Progress progress_;
    std::set<const SweepRun*, ByNumber> open_;  ///< Neither done nor failed, as far as is known.
    std::vector<Job> jobs_;
    std::map<uint64_t, int64_t> seen_;  ///< When claims of others had been renewed as they were first seen.
    std::set<uint64_t> alive_;          ///< Runs whose claims others have renewed since.
    Clock::time_point look_ = {}, renewed_ = Clock::now();
    size_t done_ = 0, failed_ = 0;
    bool isStopping_ = false;
};

/// So many threads for each run's driver as there are cores for it.
void shareCores(uint64_t jobs)
{
    if (jobs < 2 || !driverThreadsSetting().empty()) return;
    const uint64_t threads = usableCores() / jobs;
    setenv(DRIVER_THREADS_VARIABLE, std::to_string(threads < 2 ? 0 : threads).c_str(), 1);
}

}  // namespace

void workOn(const Sweep& sweep, const SweepOptions& options, const CommonOptions& common)
{
    SweepOptions own = options;
    own.jobs = std::max<uint64_t>(own.jobs, 1);
    shareCores(own.jobs);
    sweep.open();
    double seconds = 0.0;
    size_t done = 0;
    {
        const Stopwatch watch(seconds);
        Work work(sweep, own, common);
        work.run();
        done = work.doneCount();
    }
    if (!common.quiet)
        fmt::print("{} of {} done, in {}: {}; `knuckle sweep collect {}` makes a table and a page of them\n", done,
                   counted(sweep.runs.size(), "run"), durationText(seconds), sweep.folder, sweep.plan.path);
}

}  // namespace knuckle
