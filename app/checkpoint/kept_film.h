#pragma once

#include <map>
#include <mutex>
#include <set>
#include <string>

#include "render/output/frame_keep.h"

namespace knuckle {

/// A film's segments, and the frames of the one that is not complete, in a folder of their own. Each file says itself
/// whether it is whole. Frames are kept as what differs from the first of their segment, which takes half the time.
/// Used by the run and by the thread that writes.
class KeptFilm : public FilmKeep {
public:
    /// Makes the folder.
    explicit KeptFilm(std::string folder);
    std::string folder() const override { return folder_; }
    std::string segment(uint64_t segment) override;
    bool hasFrame(uint64_t index) override;
    std::vector<uint8_t> readFrame(uint64_t index) override;
    void keepFrame(uint64_t index, const std::vector<uint8_t>& rgb) override;
    std::string beginSegment() override { return "segment"; }
    void endSegment(uint64_t segment, const std::string& name) override;

    /// Looks at what the folder has, and removes what is damaged.
    void check();
    /// Removes everything.
    void forget();

private:
    std::string framePath(uint64_t index) const;

    std::string folder_;
    std::mutex mutex_;
    std::map<uint64_t, std::string> segments_;
    std::set<uint64_t> frames_;
    // Only of the thread that writes.
    std::vector<uint8_t> first_;  ///< The first frame of a segment; empty: this process has not made it.
    uint64_t firstIndex_ = 0;
};

}  // namespace knuckle
