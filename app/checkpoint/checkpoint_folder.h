#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/states/block_file.h"
#include "app/states/run_fingerprint.h"
#include "app/states/run_state.h"
#include "sim/base/files/file_descriptor.h"

namespace knuckle {

/// What a checkpoint says beside the state.
struct CheckpointFacts {
    RunFingerprint fingerprint;
    std::vector<std::string> words;  ///< Options that name the run's outputs.
    uint64_t frame = 0;              ///< All frames up to here are done.
    uint64_t logBytes = 0;           ///< Of the log, that belong to it.
};

/// A checkpoint that was found whole, with its log.
struct FoundCheckpoint {
    CheckpointFacts facts;
    std::unique_ptr<BlockReader> state, log;
};

/// `OUTPUT.checkpoint`: the last two checkpoints of a run, its log, and parts of its films. Only one process at a time
/// may have it.
class CheckpointFolder {
public:
    /// Makes and locks the folder. Removes temporary files that the process before left there and in `outputs`.
    /// @throws InputError if it cannot be written, or another process has it.
    CheckpointFolder(const std::string& path, const std::vector<std::string>& outputs);

    const std::string& path() const { return path_; }
    std::string log() const { return path_ + "/log"; }
    std::string film(size_t output) const { return path_ + "/film_" + std::to_string(output + 1); }
    /// The whole checkpoints, newest first. @param complaints gets a line for each that is not.
    std::vector<FoundCheckpoint> find(std::vector<std::string>& complaints) const;
    /// Writes a checkpoint; the one before is kept until the next. @throws RunError.
    void write(const CheckpointFacts& facts, const RunState& state) const;
    /// Removes all checkpoints and the log.
    void clear() const;

private:
    std::string name(const char* part) const { return path_ + "/" + part + ".states"; }

    std::string path_;
    FileDescriptor lock_;
};

/// "out/dance.checkpoint" of "out/dance/".
std::string checkpointPath(std::string output);

}  // namespace knuckle
