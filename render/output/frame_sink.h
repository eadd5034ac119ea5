#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

#include "render/picture/image.h"

namespace knuckle {

/// Frames that a sink holds at most.
inline constexpr size_t MAX_UNWRITTEN = 4;

/// Takes finished frames and writes them on another thread.
class FrameSink {
public:
    virtual ~FrameSink() = default;
    /// @param number as in frame_0001.png. Blocks while a few frames wait already. @throws RunError from the writer.
    virtual void write(Image image, uint64_t number) = 0;
    /// Waits for everything. @throws RunError when a frame could not be written (disk full, ffmpeg failed).
    virtual void finish() = 0;
};

/// frame_0001.png ... in `folder`, made when missing. @throws InputError when it cannot be written to.
std::unique_ptr<FrameSink> pngSink(const std::string& folder);
/// H.264, yuv420p, through the ffmpeg program; written under a temporary name, renamed by finish().
/// @throws InputError when ffmpeg is missing or the folder cannot be written to.
std::unique_ptr<FrameSink> filmSink(const std::string& path, uint32_t width, uint32_t height, double framesPerSecond);

}  // namespace knuckle
