#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "app/sweep/claim.h"

namespace knuckle {

/// How far a run is.
enum class RunStage {
    Waiting,  ///< Nobody has it.
    Running,
    Left,    ///< Who had it has gone: another may go on from its checkpoint.
    Failed,  ///< As often as it may.
    Done,
};

/// Who looks, and what counts as gone and as failed.
struct Watch {
    Worker self = Worker::self();
    double staleSeconds = 120.0;  ///< See ClaimSeen::isLeft().
    uint64_t tries = 3;           ///< After so many failures a run is not tried again.
    int64_t now = 0;              ///< Of storedNow().
};

/// What the folder of a run says.
struct RunStanding {
    RunStage stage = RunStage::Waiting;
    uint64_t claims = 0;  ///< Number of the highest.
    uint64_t failures = 0;
    std::optional<ClaimSeen> claim = {};  ///< The highest, where nobody has ended it.
    std::string line = {};                ///< The last failure's.
};

/// How a claim was ended before the run was done.
struct ClaimEnd {
    bool failed = false;  ///< Else its owner was stopped.
    std::string line;     ///< Why.
};

/// OUT/run_0001: claims, their ends, the log and what the run has made.
class RunFolder {
public:
    explicit RunFolder(std::string path) : path_(std::move(path)) {}

    const std::string& path() const { return path_; }
    std::string file(const std::string& name) const { return path_ + "/" + name; }
    std::string log() const { return file("log"); }
    std::string stats() const { return file("stats.json"); }
    std::string bodies() const { return file("bodies.csv"); }
    std::string done() const { return file("done.json"); }

    bool isDone() const;
    RunStanding look(const Watch& watch) const;
    /// @throws RunError (full disk).
    void end(uint64_t claim, const ClaimEnd& end) const;
    /// The log's last line, shortened; empty if there is none.
    std::string lastLogLine() const;

private:
    std::string path_;
};

/// "run_0001".
std::string runName(uint64_t number);

}  // namespace knuckle
