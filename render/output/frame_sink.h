#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

#include "render/output/frame_keep.h"
#include "render/output/frame_names.h"
#include "render/picture/image.h"

namespace knuckle {

/// Most frames that a sink holds.
inline constexpr size_t MAX_UNWRITTEN = 4;

/// Takes finished frames and writes them on another thread.
class FrameSink {
public:
    virtual ~FrameSink() = default;
    /// Whether it lacks the frame: one of an earlier run may be kept.
    virtual bool wants(uint64_t /*number*/) { return true; }
    /// @param number as in frame_0001.png. Blocks while several frames wait. @throws RunError from the writer.
    virtual void write(Image image, uint64_t number) = 0;
    /// Waits until all that was given is written. @throws RunError.
    virtual void flush() = 0;
    /// Waits for everything. @throws RunError when a frame could not be written (disk full, ffmpeg failed).
    virtual void finish() = 0;
};

/// Of JPEG; a frame has a third of the bytes of its PNG.
inline constexpr int DEFAULT_QUALITY = 92;

/// A picture for each frame, PNG, JPEG or EXR by its name's ending; the folder is made if missing. @throws InputError
/// if it cannot be written to.
/// @param keep must outlive it; null: nothing is kept. @param quality of JPEG, 1 to 100. @param depth bits of a channel
/// of PNG; 16, and EXR, need Image::deep.
std::unique_ptr<FrameSink> pictureSink(const FrameNames& names, PictureKeep* keep = nullptr,
                                       int quality = DEFAULT_QUALITY, uint32_t depth = 8);

struct FilmFormat {
    uint32_t width = 0, height = 0;
    double framesPerSecond = 60.0;
    std::string codec = {};  ///< As of isCodec(). Empty: the kind's first. Kinds without a choice do not ask.
    std::string pipe = {};   ///< Of streams: one of PIPE_WORDS. Empty: by its name's ending, else MP4.
};

/// What streams may get: films in one piece, and pictures as they are, in YUV 4:2:0 or in RGB of 8 bits without any
/// header.
inline constexpr std::array PIPE_WORDS{"mp4", "mkv", "webm", "y4m", "raw"};

/// The frames of a film. @param keep must outlive the film's sink; null: nothing is kept.
struct FilmPart {
    uint64_t first = 0, last = 0;  ///< 0: the first and the last that are written.
    uint64_t stride = 1;           ///< From one frame's number to the next.
    FilmKeep* keep = nullptr;
};

/// Through the ffmpeg program, of the kind of its name's ending; an OutputFile, complete after finish(). Its bytes
/// depend on nothing but the pictures and ffmpeg. A stream gets fragments that need no seeking, and keeps nothing.
/// @throws InputError if ffmpeg is missing or cannot make such a film, if it cannot be written, and for another ending.
std::unique_ptr<FrameSink> filmSink(const std::string& path, const FilmFormat& format, const FilmPart& part = {});

}  // namespace knuckle
