#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "sim/base/files/leftovers.h"
#include "sim/base/files/output_place.h"

namespace knuckle {

/// A file written piece by piece that appears under its name only when it is complete: until commit() it has a short
/// temporary name beside it, and it is removed where that is not called. What is a stream is written directly.
class OutputFile {
public:
    /// Opens it, so that nothing is worked out in vain. Folders on the way are made, but for that of a link's target.
    /// @throws InputError, naming the system's reason, where it cannot be written to, or is a folder.
    explicit OutputFile(const std::string& path) : OutputFile(OutputPlace::of(path)) {}
    explicit OutputFile(OutputPlace place);
    ~OutputFile();
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;

    /// @throws RunError with the system's reason, as from a full disk or where the reader of a pipe has gone.
    void write(std::string_view bytes);
    /// The last of it. @throws RunError.
    void commit();

    bool isStream() const { return place_.kind == OutputPlace::Kind::Stream; }
    /// For a program that writes in our place: the temporary name of what is no stream.
    const std::string& temporaryName() const { return temporary_; }
    /// The same of a stream.
    int descriptor() const { return file_; }

private:
    int openBeside();
    void flush();
    [[noreturn]] void failWriting(int error) const;

    OutputPlace place_;
    std::string temporary_;  ///< Empty: none, or not any longer.
    std::optional<Leftover> leftover_;
    int file_ = -1;
    bool emptied_ = false;
    std::string unwritten_;
};

/// Writes a whole file. @throws as OutputFile.
void writeFile(const std::string& path, std::string_view bytes);

/// Makes the folder with its parents where it is missing and tries to write there. @throws InputError with the system's
/// reason, and for what is no folder.
void requireWritableFolder(const std::string& folder);

}  // namespace knuckle
