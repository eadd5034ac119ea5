#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace knuckle {

/// What sinks have kept of an earlier run that ended before its time, and what they keep for one to come.

/// Of pictures.
class PictureKeep {
public:
    virtual ~PictureKeep() = default;
    /// Whether the frame is there and whole.
    virtual bool has(uint64_t number) = 0;
    /// A frame has been written. On the sink's thread. @param bytes of its file.
    virtual void written(uint64_t number, std::string_view bytes) = 0;
};

/// Of a film, which is encoded in segments. Frames and segments are counted from 0.
class FilmKeep {
public:
    virtual ~FilmKeep() = default;
    /// The folder of all segments.
    virtual std::string folder() const = 0;
    /// Name of a complete segment; empty if it is not there or not whole.
    virtual std::string segment(uint64_t segment) = 0;
    /// Whether a frame of an incomplete segment is there and whole.
    virtual bool hasFrame(uint64_t index) = 0;
    /// @throws RunError if it is not there.
    virtual std::vector<uint8_t> readFrame(uint64_t index) = 0;
    /// Keeps a frame until its segment is complete.
    virtual void keepFrame(uint64_t index, const std::vector<uint8_t>& rgb) = 0;
    /// A new name in the folder for a segment that is to be encoded.
    virtual std::string beginSegment() = 0;
    /// The segment with that name is complete; its frames are not needed any more.
    virtual void endSegment(uint64_t segment, const std::string& name) = 0;
};

}  // namespace knuckle
