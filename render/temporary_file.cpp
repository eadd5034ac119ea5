#include "render/temporary_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <system_error>

#include "sim/world/errors.h"

namespace knuckle {

namespace {

[[noreturn]] void fail(const std::string& path, int error)
{
    throw RunError(fmt::format("{} cannot be written: {}", path, std::strerror(error)));
}

}  // namespace

std::string folderOf(const std::string& path)
{
    const std::filesystem::path folder = std::filesystem::path(path).parent_path();
    return folder.empty() ? "." : folder.string();
}

TemporaryFile::TemporaryFile(std::string path) : path_(std::move(path))
{
    const std::filesystem::path full(path_);
    name_ = fmt::format("{}/.{}.{}.partial{}", folderOf(path_), full.stem().string(), getpid(),
                        full.extension().string());
}

TemporaryFile::~TemporaryFile()
{
    if (!committed_) unlink(name_.c_str());
}

void TemporaryFile::write(const void* data, size_t byteCount)
{
    const int file = open(name_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (file < 0) fail(path_, errno);
    const auto* next = static_cast<const char*>(data);
    while (byteCount > 0) {
        const ssize_t written = ::write(file, next, byteCount);
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) {
            const int error = written < 0 ? errno : ENOSPC;
            close(file);
            fail(path_, error);
        }
        next += written;
        byteCount -= static_cast<size_t>(written);
    }
    if (close(file) != 0) fail(path_, errno);
}

void TemporaryFile::commit()
{
    if (std::rename(name_.c_str(), path_.c_str()) != 0) fail(path_, errno);
    committed_ = true;
}

void requireWritableFolder(const std::string& folder)
{
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error && !std::filesystem::is_directory(folder))
        throw InputError(fmt::format("folder {} cannot be made: {}; choose another", folder, error.message()));
    // Asking for the permission bits would not notice a read-only file system.
    try {
        TemporaryFile probe(folder + "/probe");
        probe.write("", 0);
    } catch (const RunError&) {
        throw InputError(
            fmt::format("folder {} cannot be written to: {}; choose another", folder, std::strerror(errno)));
    }
}

}  // namespace knuckle
