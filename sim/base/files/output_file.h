#pragma once

#include <sys/types.h>

#include <optional>
#include <string>
#include <string_view>

#include "sim/base/files/leftovers.h"
#include "sim/base/files/output_place.h"

namespace knuckle {

/// A file written piece by piece that appears under its name only when complete: until commit() it has a short
/// temporary name beside it, and it is removed without commit(). A stream is written directly.
class OutputFile {
public:
    /// Opens it early, so that no work is done in vain. Makes missing folders, except that of a link's target.
    /// @throws InputError, with the system's reason, if it cannot be written to, or is a folder.
    explicit OutputFile(const std::string& path) : OutputFile(OutputPlace::of(path)) {}
    explicit OutputFile(OutputPlace place);
    ~OutputFile();
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;

    /// @throws RunError with the system's reason, such as a full disk or a closed pipe.
    void write(std::string_view bytes);
    /// For logs, which count even if the program is killed: gives the file its name now, and writes at once what comes
    /// later. @throws RunError.
    void appear();
    /// Completes the file. @throws RunError.
    void commit();
    /// The same, and waits until the file and its name are on the disk.
    void commitDurably();

    bool isStream() const { return place_.kind == OutputPlace::Kind::Stream; }
    /// For another program that writes the file: its temporary name, if it is no stream.
    const std::string& temporaryName() const { return temporary_; }
    /// The same for a stream.
    int descriptor() const { return file_; }

private:
    int openBeside();
    void flush();
    void name();
    [[noreturn]] void failWriting(int error) const;

    OutputPlace place_;
    std::string temporary_;  ///< Empty: none, or not any longer.
    std::optional<Leftover> leftover_;
    int file_ = -1;
    bool emptied_ = false, appeared_ = false;
    std::string unwritten_;
};

/// Writes a whole file. @throws as OutputFile.
void writeFile(const std::string& path, std::string_view bytes);

/// Removes temporary files that a process left in a folder; nothing if it still runs.
void removeTemporaries(const std::string& folder, pid_t process);

/// Makes the folder and its parents if missing and tries to write there. @throws InputError with the system's reason,
/// or if it is no folder.
void requireWritableFolder(const std::string& folder);

}  // namespace knuckle
