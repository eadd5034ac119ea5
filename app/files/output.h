#pragma once

#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "render/temporary_file.h"

namespace knuckle {

/// A file written piece by piece that appears under its name only when it is complete, see TemporaryFile. What is no
/// regular file (a pipe, /dev/stdout) is written directly.
class OutputFile {
public:
    /// @throws InputError when it cannot be written to. Folders on the way are made.
    explicit OutputFile(std::string path);
    ~OutputFile();
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;

    /// @throws RunError, as from a full disk; std::system_error where the reader of a pipe has gone.
    void write(std::string_view bytes);
    void commit();

private:
    [[noreturn]] void failWriting() const;
    struct Close {
        void operator()(std::FILE* file) const { std::fclose(file); }
    };
    std::string path_;
    std::optional<TemporaryFile> temporary_;
    std::unique_ptr<std::FILE, Close> file_;
};

}  // namespace knuckle
