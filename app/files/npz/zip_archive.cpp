#include "app/files/npz/zip_archive.h"

#include <fmt/format.h>
#include <minizip/unzip.h>
#include <minizip/zip.h>

#include <algorithm>
#include <array>
#include <memory>
#include <stdexcept>

#include "sim/base/errors.h"

namespace knuckle {

namespace {

constexpr uint64_t MAX_BYTES = uint64_t{256} << 20;

/// What the library takes for a file: bytes that are read, or grow.
struct MemoryFile {
    std::string_view read;
    std::string written;
    bool writes = false;
    size_t at = 0;

    size_t size() const { return writes ? written.size() : read.size(); }
};

MemoryFile& fileOf(voidpf opaque)
{
    return *static_cast<MemoryFile*>(opaque);
}

voidpf openFile(voidpf opaque, const void* /*name*/, int /*mode*/)
{
    return opaque;
}

uLong readFile(voidpf opaque, voidpf /*stream*/, void* bytes, uLong size)
{
    MemoryFile& file = fileOf(opaque);
    const std::string_view all = file.writes ? std::string_view(file.written) : file.read;
    const std::string_view part = all.substr(std::min(file.at, all.size()), size);
    std::ranges::copy(part, static_cast<char*>(bytes));
    file.at += part.size();
    return part.size();
}

uLong writeFile(voidpf opaque, voidpf /*stream*/, const void* bytes, uLong size)
{
    MemoryFile& file = fileOf(opaque);
    file.written.resize(std::max(file.written.size(), file.at + size));
    std::copy_n(static_cast<const char*>(bytes), size, file.written.begin() + static_cast<std::ptrdiff_t>(file.at));
    file.at += size;
    return size;
}

ZPOS64_T placeIn(voidpf opaque, voidpf /*stream*/)
{
    return fileOf(opaque).at;
}

long seekIn(voidpf opaque, voidpf /*stream*/, ZPOS64_T offset, int origin)
{
    MemoryFile& file = fileOf(opaque);
    const size_t from = origin == ZLIB_FILEFUNC_SEEK_SET ? 0 : origin == ZLIB_FILEFUNC_SEEK_CUR ? file.at : file.size();
    if (offset > file.size() - std::min(from, file.size())) return -1;
    file.at = from + offset;
    return 0;
}

int succeed(voidpf /*opaque*/, voidpf /*stream*/)
{
    return 0;
}

zlib_filefunc64_def accessTo(MemoryFile& file)
{
    return {openFile, readFile, writeFile, placeIn, seekIn, succeed, succeed, &file};
}

/// The bytes of the file that the archive is at. @param room how many there may be.
std::string unpacked(unzFile archive, const std::string& path, const std::string& name, uint64_t size)
{
    std::string bytes(size, '\0');
    size_t filled = 0;
    bool fine = unzOpenCurrentFile(archive) == UNZ_OK;
    while (fine && filled < size) {
        const int count = unzReadCurrentFile(archive, bytes.data() + filled, static_cast<unsigned>(size - filled));
        fine = count > 0;
        filled += fine ? static_cast<size_t>(count) : 0;
    }
    if (unzCloseCurrentFile(archive) != UNZ_OK || !fine)
        throw InputError(
            fmt::format("{}: {} in it is damaged, or packed in an unknown way; save the file again", path, name));
    return bytes;
}

void require(bool done)
{
    if (!done) throw std::logic_error("a zip archive in memory could not be written");
}

/// Whether its last record is whole: 22 bytes, and a comment of the length that the last two of them say.
bool hasEnd(std::string_view bytes)
{
    constexpr size_t SIZE = 22;
    const size_t at = bytes.rfind("PK\5\6");
    if (at == std::string_view::npos || bytes.size() < at + SIZE) return false;
    const auto byte = [&](size_t k) { return static_cast<size_t>(static_cast<uint8_t>(bytes[at + k])); };
    return bytes.size() >= at + SIZE + byte(SIZE - 2) + 256 * byte(SIZE - 1);
}

}  // namespace

ZipEntries readZip(std::string_view bytes, const std::string& path)
{
    MemoryFile file;
    file.read = bytes;
    zlib_filefunc64_def access = accessTo(file);
    const std::unique_ptr<void, decltype(&unzClose)> archive(unzOpen2_64(nullptr, &access), unzClose);
    // The library takes an archive whose last record is cut short.
    if (!archive || !hasEnd(bytes))
        throw InputError(fmt::format("{}: is no zip archive, or ends early; save it again", path));
    ZipEntries entries;
    uint64_t total = 0;
    int more = unzGoToFirstFile(archive.get());
    for (; more == UNZ_OK; more = unzGoToNextFile(archive.get())) {
        unz_file_info64 info{};
        std::array<char, 1024> name{};
        if (unzGetCurrentFileInfo64(archive.get(), &info, name.data(), name.size() - 1, nullptr, 0, nullptr, 0) !=
            UNZ_OK)
            break;
        if (info.uncompressed_size > MAX_BYTES - total)
            throw InputError(fmt::format("{}: unpacks to more than the limit of {} MiB", path, MAX_BYTES >> 20));
        total += info.uncompressed_size;
        entries.emplace_back(name.data(), unpacked(archive.get(), path, name.data(), info.uncompressed_size));
    }
    if (more != UNZ_END_OF_LIST_OF_FILE)
        throw InputError(fmt::format("{}: its list of files is damaged; save it again", path));
    return entries;
}

std::string zipOf(const ZipEntries& entries)
{
    MemoryFile file;
    file.writes = true;
    zlib_filefunc64_def access = accessTo(file);
    void* archive = zipOpen2_64(nullptr, APPEND_STATUS_CREATE, nullptr, &access);
    require(archive != nullptr);
    zip_fileinfo info{};
    info.dosDate = (1u << 5) | 1u;  // 1 January 1980, whenever it is written
    for (const auto& [name, bytes] : entries) {
        require(zipOpenNewFileInZip64(archive, name.c_str(), &info, nullptr, 0, nullptr, 0, nullptr, 0, 0, 0) ==
                    ZIP_OK &&
                zipWriteInFileInZip(archive, bytes.data(), static_cast<unsigned>(bytes.size())) == ZIP_OK &&
                zipCloseFileInZip(archive) == ZIP_OK);
    }
    require(zipClose(archive, nullptr) == ZIP_OK);
    return file.written;
}

}  // namespace knuckle
