#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

#include "render/picture/image.h"

namespace knuckle {

/// Most frames that a sink holds.
inline constexpr size_t MAX_UNWRITTEN = 4;

/// Takes finished frames and writes them on another thread.
class FrameSink {
public:
    virtual ~FrameSink() = default;
    /// @param number as in frame_0001.png. Blocks while several frames wait. @throws RunError from the writer.
    virtual void write(Image image, uint64_t number) = 0;
    /// Waits for everything. @throws RunError when a frame could not be written (disk full, ffmpeg failed).
    virtual void finish() = 0;
};

/// frame_0001.png ... in `folder`, which is made if missing. @throws InputError if it cannot be written to.
std::unique_ptr<FrameSink> pngSink(const std::string& folder);
/// Endings of films that can be written.
inline constexpr std::array FILM_ENDINGS{".mp4", ".mov", ".mkv"};

/// H.264, yuv420p, through the ffmpeg program; an OutputFile, complete after finish(). A stream gets the format of its
/// name's ending, else MP4, in fragments that need no seeking.
/// @throws InputError if ffmpeg is missing or the film cannot be written, and for another ending.
std::unique_ptr<FrameSink> filmSink(const std::string& path, uint32_t width, uint32_t height, double framesPerSecond);

}  // namespace knuckle
