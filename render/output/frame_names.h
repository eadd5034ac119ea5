#pragma once

#include <array>
#include <cstdint>
#include <string>

namespace knuckle {

/// Endings of pictures that frames are written as.
inline constexpr std::array PICTURE_ENDINGS{".png", ".jpg", ".jpeg", ".exr"};

/// What the frames of one output are called: `folder`, then `before`, the frame's number and `after`.
struct FrameNames {
    std::string folder, before = "frame_", after = ".png";
    size_t digits = 4;   ///< At least; larger numbers have more. 0: no number, a single picture.
    bool given = false;  ///< Named by the user, not only their folder.

    /// Whether an output names pictures, as `DIR/name_####.png` does, and no folder of them: by its ending, unless
    /// there is such a folder or a slash follows. For streams, no.
    static bool areGivenBy(const std::string& output);
    /// Of an output: the names that it gives, where # stand for digits; else frame_0001.png ... in it as a folder.
    /// @throws InputError for more than one group of #.
    static FrameNames of(const std::string& output);

    std::string path(uint64_t number) const;
    /// Whether a file of that name would be written over.
    bool has(const std::string& name) const;
    /// Whether both could write one file, were their folders the same.
    bool mayMeet(const FrameNames& other) const;
    bool areJpeg() const;
    bool areExr() const;
};

}  // namespace knuckle
