#pragma once

#include <string>

namespace knuckle {

/// What an output is, by what stands where it goes. This alone decides how it is written:
/// - a file, or nothing yet: under a temporary name beside it, renamed once it is complete, see OutputFile;
/// - a symbolic link: the same of what it names, there already or not; the link stays;
/// - a stream (device, pipe, `-` for standard output, /dev/fd/N, a file mounted by itself): as it is, never replaced;
/// - a folder.
struct OutputPlace {
    enum class Kind { File, Stream, Folder };

    Kind kind = Kind::File;
    std::string given;    ///< As the user wrote it, shortened for messages.
    std::string path;     ///< Absolute, without links; empty where the stream is open already.
    bool linked = false;  ///< `path` is what a link names.
    int descriptor = -1;  ///< Of a stream that this process has open.

    /// Opens and makes nothing.
    /// @throws InputError for an empty or too long name, links without end, a socket, a working folder that is gone.
    static OutputPlace of(const std::string& path);

    /// A descriptor of a stream, to be closed by the caller. From the first call for standard output on, what the
    /// program prints goes to standard error, so that the output has it for itself. Waits for a FIFO's reader.
    /// @throws InputError.
    int open() const;
};

/// A path as it stands in a message: of a long one both ends.
std::string shownPath(const std::string& path);
/// The folder part of `path`, "." where it has none.
std::string folderOf(const std::string& path);

}  // namespace knuckle
