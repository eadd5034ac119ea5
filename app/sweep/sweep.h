#pragma once

#include <string>
#include <vector>

#include "app/run/open_gpu.h"
#include "app/sweep/plan.h"
#include "app/sweep/run_folder.h"
#include "app/sweep/runs.h"

namespace knuckle {

/// What `knuckle sweep` is told.
struct SweepOptions {
    std::string plan, folder;  ///< The folder may be empty: out/NAME.
    uint64_t jobs = 0;         ///< Runs at once; 0: not told.
    Watch watch = {};
    bool leave = false;  ///< Do not wait for what others work on.
    std::string slurm;   ///< Options of sbatch; empty: run here.
};

/// A plan, its runs and where they are.
struct Sweep {
    SweepPlan plan;
    std::vector<SweepRun> runs;
    std::string folder;

    /// @throws InputError for a plan that is wrong by itself.
    static Sweep read(const SweepOptions& options);
    RunFolder folderOf(const SweepRun& run) const { return RunFolder(folder + "/" + runName(run.number)); }
    std::string headPath() const { return folder + "/sweep.json"; }
    /// Makes the folder. @throws InputError where it cannot be, and where it holds runs of another plan; RunError
    /// (full disk).
    void open() const;
    /// @throws InputError where there are none of this plan.
    void requireRuns() const;
};

/// Writes some bytes there and takes them away again. @throws RunError if there is no room for them.
void requireRoom(const std::string& folder);

/// Options that start a run: those of `knuckle render`.
std::vector<std::string> runCommand(const Sweep& sweep, const SweepRun& run, const CommonOptions& common);

/// Works on runs that nobody has until all are done, or failed too often. @throws RunError if any has failed, and for
/// a full disk; DeviceError; Interrupted, when all that was worked on has its checkpoint.
void workOn(const Sweep& sweep, const SweepOptions& options, const CommonOptions& common);

/// Prints how far the runs are. @param json as JSON.
void printStatus(const Sweep& sweep, const Watch& watch, bool json);

/// Writes OUT/table.csv and OUT/index.html. @throws RunError if runs are missing in them.
void collectSweep(const Sweep& sweep, const Watch& watch, bool quiet);

/// Writes OUT/sweep.sbatch and gives it to sbatch. @throws InputError if that refuses it.
void submitToSlurm(const Sweep& sweep, const SweepOptions& options, const CommonOptions& common);

}  // namespace knuckle
