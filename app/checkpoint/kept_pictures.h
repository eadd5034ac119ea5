#pragma once

#include <map>
#include <mutex>
#include <set>
#include <string>
#include <vector>

#include "app/states/block_file.h"
#include "render/output/frame_keep.h"
#include "render/output/frame_names.h"

namespace knuckle {

/// Knows by their checksums which frames of a folder are whole. Used by the run and by the thread that writes.
class KeptPictures : public PictureKeep {
public:
    /// @param number of the output, for the log.
    KeptPictures(size_t number, FrameNames names) : number_(number), names_(std::move(names)) {}
    bool has(uint64_t number) override;
    void written(uint64_t number, std::string_view bytes) override;

    /// Reads each frame that the log tells of, and takes those that are whole.
    void check(const BlockReader& log);
    void forget();
    /// Blocks for the log: what was written since the last call.
    std::vector<std::string> news();
    /// Of frames that were found whole, for a log that begins anew.
    std::vector<std::string> all();

private:
    std::string block(uint64_t frame, const std::string& sum) const;

    size_t number_;
    FrameNames names_;
    std::mutex mutex_;
    std::map<uint64_t, std::string> whole_;  ///< Checksum and size of the file.
    std::set<uint64_t> news_;
};

}  // namespace knuckle
