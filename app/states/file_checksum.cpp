#include "app/states/file_checksum.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

#include "app/states/block_pack.h"
#include "sim/base/errors.h"

namespace knuckle {

namespace {

std::string checksumText(uint32_t checksum, uint64_t bytes)
{
    return fmt::format("{:08x}-{:x}", checksum, bytes);
}

}  // namespace

std::string checksumOf(std::string_view bytes)
{
    return checksumText(crc32(bytes), bytes.size());
}

std::string fileChecksum(const std::string& path)
{
    const std::unique_ptr<FILE, int (*)(FILE*)> file(std::fopen(path.c_str(), "rb"), std::fclose);
    if (!file) throw InputError(fmt::format("{} cannot be read: {}", path, std::strerror(errno)));
    std::string piece(size_t{1} << 20, '\0');
    uint32_t checksum = 0;
    uint64_t bytes = 0;
    for (size_t got = 0; (got = std::fread(piece.data(), 1, piece.size(), file.get())) > 0; bytes += got)
        checksum = crc32({piece.data(), got}, checksum);
    return checksumText(checksum, bytes);
}

}  // namespace knuckle
