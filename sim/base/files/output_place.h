#pragma once

#include <string>

namespace knuckle {

/// The kind of an output, by what exists at its path. This alone decides how it is written:
/// - a file, or nothing yet: under a temporary name beside it, renamed once it is complete, see OutputFile;
/// - a symbolic link: like its target, whether it exists or not; the link stays;
/// - a stream (device, pipe, `-` for standard output, /dev/fd/N, a file mounted by itself): in place, never replaced;
/// - a folder.
struct OutputPlace {
    enum class Kind { File, Stream, Folder };

    Kind kind = Kind::File;
    std::string given;    ///< As the user gave it, shortened for messages.
    std::string path;     ///< Absolute, without links; empty if the stream is open already.
    bool linked = false;  ///< `path` is a link's target.
    int descriptor = -1;  ///< Of a stream that is already open in this process.

    /// Opens and creates nothing.
    /// @throws InputError for an empty or too long name, endless links, a socket, a working folder that is gone.
    static OutputPlace of(const std::string& path);

    /// A descriptor of a stream, which the caller closes. After the first call for standard output, the program prints
    /// to standard error, so that only the output goes there. Waits for a FIFO's reader.
    /// @throws InputError.
    int open() const;
};

/// A path for messages: a long one shortened to both ends.
std::string shownPath(const std::string& path);
/// The folder part of `path`, "." if it has none.
std::string folderOf(const std::string& path);

}  // namespace knuckle
