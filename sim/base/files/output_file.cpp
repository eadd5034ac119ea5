#include "sim/base/files/output_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <utility>

#include "sim/base/errors.h"
#include "sim/base/files/file_descriptor.h"

namespace knuckle {

namespace {

namespace fs = std::filesystem;

constexpr size_t BLOCK = size_t{1} << 16;  // bytes written at once

/// Short, since the final name may be as long as the file system allows.
std::string temporaryPrefix(pid_t process)
{
    return fmt::format(".knuckle.{}.", process);
}

/// Unique to this process.
std::string temporaryNameIn(const std::string& folder)
{
    static std::atomic<uint32_t> count = 0;
    return fmt::format("{}/{}{}", folder, temporaryPrefix(getpid()), ++count);
}

int create(const std::string& path)
{
    return open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
}

}  // namespace

OutputFile::OutputFile(OutputPlace place) : place_(std::move(place))
{
    if (place_.kind == OutputPlace::Kind::Folder)
        throw InputError(fmt::format("{}: is a folder; name a file", place_.given));
    file_ = isStream() ? place_.open() : openBeside();
}

int OutputFile::openBeside()
{
    const std::string folder = folderOf(place_.path);
    std::error_code failure;
    // A link's target folder is not made.
    if (!place_.linked) fs::create_directories(folder, failure);
    int file = -1;
    do {
        temporary_ = temporaryNameIn(folder);
        leftover_.emplace(temporary_);  // before it exists: a signal may come in between
        file = create(temporary_);
    } while (file < 0 && errno == EEXIST);
    if (file < 0) {
        const int own = errno, error = failure && !fs::is_directory(folder) ? failure.value() : own;
        temporary_.clear();
        leftover_.reset();
        throw InputError(
            fmt::format("{} cannot be written: {}; choose another place", place_.given, std::strerror(error)));
    }
    return file;
}

OutputFile::~OutputFile()
{
    if (file_ >= 0) close(file_);
    if (!temporary_.empty()) unlink(temporary_.c_str());
}

void OutputFile::write(std::string_view bytes)
{
    unwritten_ += bytes;
    if (appeared_ || unwritten_.size() >= BLOCK) flush();
}

void OutputFile::appear()
{
    flush();
    name();
    appeared_ = true;
}

void OutputFile::name()
{
    if (temporary_.empty()) return;
    if (std::rename(temporary_.c_str(), place_.path.c_str()) != 0) failWriting(errno);
    temporary_.clear();
    leftover_.reset();
}

void OutputFile::flush()
{
    // A file mounted by itself is overwritten in place.
    if (!std::exchange(emptied_, true) && isStream() && !place_.path.empty()) {
        struct stat facts = {};
        if (fstat(file_, &facts) == 0 && S_ISREG(facts.st_mode) && ftruncate(file_, 0) != 0) failWriting(errno);
    }
    if (const int error = writeAll(file_, unwritten_); error != 0) failWriting(error);
    unwritten_.clear();
}

void OutputFile::commit()
{
    flush();
    if (close(std::exchange(file_, -1)) != 0) failWriting(errno);
    name();
}

void OutputFile::commitDurably()
{
    flush();
    if (fsync(file_) != 0 && errno != EINVAL) failWriting(errno);  // EINVAL: a stream
    const bool named = !temporary_.empty();
    commit();
    const int folder = named ? open(folderOf(place_.path).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC) : -1;
    if (folder < 0) return;
    fsync(folder);  // some file systems cannot: then the name comes when they see fit
    close(folder);
}

void OutputFile::failWriting(int error) const
{
    if (error == EPIPE) throw RunError(fmt::format("{} cannot be written: its reader has gone", place_.given));
    throw RunError(fmt::format("{} cannot be written: {}", place_.given, std::strerror(error)));
}

void writeFile(const std::string& path, std::string_view bytes)
{
    OutputFile file(path);
    file.write(bytes);
    file.commit();
}

void removeTemporaries(const std::string& folder, pid_t process)
{
    if (process <= 0 || process == getpid() || kill(process, 0) == 0 || errno == EPERM) return;
    std::error_code ignored;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored)) {
        const std::string name = entry.path().filename();
        if (name.starts_with(temporaryPrefix(process))) unlink(entry.path().c_str());
    }
}

void requireWritableFolder(const std::string& folder)
{
    const OutputPlace place = OutputPlace::of(folder);
    const auto fail = [&](const char* what, const std::string& why) {
        throw InputError(fmt::format("folder {} cannot be {}: {}; choose another", place.given, what, why));
    };
    if (place.kind == OutputPlace::Kind::Stream)
        throw InputError(fmt::format("{} is no folder; choose one", place.given));
    std::error_code error;
    fs::create_directories(place.path, error);
    if (error && !fs::is_directory(place.path)) fail("made", error.message());
    // Permission bits would not show a read-only file system.
    const std::string probe = temporaryNameIn(place.path);
    const Leftover leftover(probe);
    const int file = create(probe);
    if (file < 0) fail("written to", std::strerror(errno));
    close(file);
    unlink(probe.c_str());
}

}  // namespace knuckle
