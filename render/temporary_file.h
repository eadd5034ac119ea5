#pragma once

#include <string>

namespace knuckle {

/// A name beside `path` under which a file is written before commit() renames it, so that nobody sees half of it.
/// Whatever was not committed is removed.
class TemporaryFile {
public:
    /// Only makes up the name, which keeps the extension of `path` and is unique to this process.
    explicit TemporaryFile(std::string path);
    ~TemporaryFile();
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;

    const std::string& name() const { return name_; }
    /// Writes the whole file. @throws RunError naming `path` and the system's reason.
    void write(const void* data, size_t byteCount);
    /// Renames to `path`. @throws RunError.
    void commit();

private:
    std::string path_, name_;
    bool committed_ = false;
};

/// The folder part of `path`, "." where it has none.
std::string folderOf(const std::string& path);
/// Makes `folder` with its parents where it is missing and tries to write there.
/// @throws InputError with the system's reason.
void requireWritableFolder(const std::string& folder);

}  // namespace knuckle
