#pragma once

#include <cstdint>
#include <mutex>
#include <set>

#include "render/output/frame_keep.h"
#include "render/output/frame_names.h"

namespace knuckle {

/// Frames that lie there already, whoever drew them, are as good as kept. Used by the run and by the thread that
/// writes.
class ExistingPictures : public PictureKeep {
public:
    /// @param width, height of the frames: others are drawn again. @param keep is told of what is found; must outlive
    /// it; null: none.
    ExistingPictures(FrameNames names, uint32_t width, uint32_t height, PictureKeep* keep = nullptr);
    /// Looks at the file, once.
    bool has(uint64_t number) override;
    void written(uint64_t number, std::string_view bytes) override;

private:
    const FrameNames names_;
    const uint32_t width_, height_;
    PictureKeep* const keep_;
    std::mutex mutex_;
    std::set<uint64_t> whole_;
};

}  // namespace knuckle
