#include "app/files/output.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>

#include "sim/world/errors.h"

namespace knuckle {

OutputFile::OutputFile(std::string path) : path_(std::move(path))
{
    const std::filesystem::path target(path_);
    if (std::filesystem::is_directory(target)) throw InputError(fmt::format("{}: is a folder; name a file", path_));
    if (!std::filesystem::exists(target) || std::filesystem::is_regular_file(target)) {
        requireWritableFolder(folderOf(path_));
        temporary_.emplace(path_);
    }
    file_.reset(std::fopen(temporary_ ? temporary_->name().c_str() : path_.c_str(), "wb"));
    if (file_) return;
    throw InputError(fmt::format("{}: cannot be written: {}; choose another place", path_, std::strerror(errno)));
}

OutputFile::~OutputFile() = default;

void OutputFile::write(std::string_view bytes)
{
    if (std::fwrite(bytes.data(), 1, bytes.size(), file_.get()) != bytes.size()) failWriting();
}

void OutputFile::commit()
{
    if (std::fflush(file_.get()) != 0) failWriting();
    file_.reset();
    if (temporary_) temporary_->commit();
}

void OutputFile::failWriting() const
{
    if (errno == EPIPE) throw std::system_error(errno, std::generic_category(), path_);
    throw RunError(fmt::format("{}: cannot be written: {}", path_, std::strerror(errno)));
}

}  // namespace knuckle
