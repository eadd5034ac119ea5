#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "render/output/ffmpeg.h"
#include "render/output/film_encoding.h"
#include "render/output/frame_keep.h"
#include "render/output/frame_sink.h"

namespace knuckle {

/// Frames of a segment, each of which begins with a key frame; as many as x264 leaves between key frames by itself.
inline constexpr uint64_t SEGMENT_FRAMES = 250;

/// A film that is encoded segment by segment and joined at the end, so that its bytes do not depend on whether it was
/// made in one run or in several.
class FilmSegments {
public:
    /// @param ffmpeg path of the program. @param purpose names the film in messages. @param keep must outlive it.
    FilmSegments(std::string ffmpeg, FilmFormat format, FilmEncoding encoding, std::string purpose, FilmKeep& keep);
    /// Whether the frame is needed for a segment that is not complete.
    bool wants(uint64_t index);
    /// Frames come in order; those that are not wanted may be left out. @throws RunError.
    void write(uint64_t index, const std::vector<uint8_t>& rgb);
    /// Joins all segments. @param frames their number. @param output file that gets the film. @throws RunError.
    void finish(uint64_t frames, const std::string& output);

private:
    void feedKept(uint64_t end);
    void feed(const std::vector<uint8_t>& rgb);
    void skipComplete();
    void join(uint64_t frames, const std::vector<std::string>& names, const std::string& output) const;

    std::string ffmpeg_;
    FilmFormat format_;
    FilmEncoding encoding_;
    std::string purpose_;
    FilmKeep& keep_;
    uint64_t next_ = 0;  ///< The frame that the encoder needs next.
    std::optional<Ffmpeg> encoder_;
    std::string encoded_;  ///< Name of the segment in work.
};

/// Segments under temporary names beside a film, removed with it.
std::unique_ptr<FilmKeep> temporaryKeep(const std::string& film);

}  // namespace knuckle
