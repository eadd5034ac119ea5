#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "app/states/frame_record.h"
#include "app/states/states_file.h"

namespace knuckle {

/// Options `--record`, `--record-every` and `--save-state`.
struct RecordOptions {
    std::string states;  ///< A file for what is drawn of every frame, and whole states. Empty: none.
    uint64_t every = 0;  ///< Frames from one whole state to the next; 0: those of a second.
    std::string last;    ///< A file for the last frame and its whole state. Empty: none.

    bool any() const { return !states.empty() || !last.empty(); }
};

/// "states=FILE". @throws InputError for anything else.
std::string parseRecord(const std::string& text);

/// Writes the files of states of a run.
class Recording {
public:
    /// Opens the files. @param first, last frame of the run. @throws InputError for a file that cannot be written.
    Recording(const RecordOptions& options, const Scene& scene, const RunFacts& facts, uint64_t first, uint64_t last);

    bool wantsView(uint64_t frame) const { return states_ || isLast(frame); }
    bool wantsState(uint64_t frame) const
    {
        return isLast(frame) || (states_ && (frame == first_ || (frame - 1) % every_ == 0));
    }
    /// @param record with a view and a state if they are wanted. @throws RunError from a full disk.
    void frame(const FrameRecord& record);
    void finish();

private:
    bool isLast(uint64_t frame) const { return frame == last_; }

    std::optional<StatesWriter> states_, end_;
    uint64_t every_ = 1, first_ = 1, last_ = 0;
};

}  // namespace knuckle
