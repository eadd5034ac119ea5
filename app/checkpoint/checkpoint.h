#pragma once

#include <chrono>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/checkpoint/checkpoint_folder.h"
#include "app/checkpoint/frame_log.h"
#include "app/checkpoint/kept_film.h"
#include "app/checkpoint/kept_pictures.h"
#include "app/film/frame_range.h"

namespace knuckle {

/// Options `--checkpoint` and `--resume`.
struct CheckpointOptions {
    std::optional<double> seconds;     ///< Of wall-clock time from one checkpoint to the next; none: no checkpoints.
    bool resume = false;               ///< Go on from what an earlier run left.
    bool loose = false;                ///< Also where bits will differ.
    std::vector<std::string> words;    ///< Options that name the run's outputs.
    std::vector<std::string> folders;  ///< Where they lie.
};

/// Lets a run that was ended go on: writes its state from time to time, logs what exports are written from, and knows
/// which frames are done.
class Checkpoint {
public:
    /// @param outputs as given to -o, of which the first names the folder. @param range of the frames to draw.
    /// @throws InputError as CheckpointFolder.
    Checkpoint(const CheckpointOptions& options, const std::vector<std::string>& outputs, const FrameRange& range,
               const World& world);

    /// What is kept of an output, by its index.
    PictureKeep* pictures(size_t output, const FrameNames& names);
    FilmKeep* film(size_t output);

    /// Finds the state to go on from; none: the run begins at its start, and frames that are whole need not be drawn.
    /// Call it once, when all outputs are known. @param last frame of the run. @throws InputError if what was left is
    /// of another run.
    std::optional<RunState> begin(const RunFingerprint& fingerprint, uint64_t last);
    /// For the user: what begin() found, a line each.
    const std::vector<std::string>& notes() const { return notes_; }
    /// Gives the records of all frames from the run's first up to the state's, in order.
    void replay(uint64_t first, const std::function<void(const FrameRecord&)>& give) const;

    /// @throws RunError (full disk).
    void log(const FrameRecord& record);
    /// Whether the time for the next one has come.
    bool isDue() const;
    /// All outputs must have written all frames up to the state's. @throws RunError.
    void save(const RunState& state);

private:
    using Clock = std::chrono::steady_clock;

    void requireSameRun(const FoundCheckpoint& found, uint64_t last) const;
    bool isWhole(uint64_t frame);
    std::optional<uint64_t> firstMissing(uint64_t last);
    void beginAnew(bool keepFrames);

    CheckpointOptions options_;
    CheckpointFolder folder_;
    FrameRange range_;
    ViewCoding coding_;
    std::map<size_t, std::unique_ptr<KeptPictures>> pictures_;
    std::map<size_t, std::unique_ptr<KeptFilm>> films_;
    std::vector<std::string> notes_;
    CheckpointFacts facts_;
    std::unique_ptr<BlockReader> earlier_;  ///< The log of the run before.
    std::optional<FrameLog> log_;
    Clock::time_point saved_ = Clock::now();
};

}  // namespace knuckle
