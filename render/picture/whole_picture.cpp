#include "render/picture/whole_picture.h"

#include <libdeflate.h>
#include <stb/stb_image.h>

namespace knuckle {

namespace {

constexpr std::string_view PNG_START{"\x89PNG\r\n\x1a\n", 8}, JPEG_START{"\xff\xd8"}, JPEG_END{"\xff\xd9"};

/// Big-endian.
uint32_t numberAt(std::string_view bytes, size_t at)
{
    uint32_t number = 0;
    for (size_t k = 0; k < 4; ++k) number = number << 8 | static_cast<uint8_t>(bytes[at + k]);
    return number;
}

/// Whether all chunks up to the last are as they were written: length, kind, data, checksum of the latter two.
bool areChunksWhole(std::string_view bytes)
{
    constexpr size_t FRAMING = 12;
    for (size_t at = PNG_START.size(); bytes.size() - at >= FRAMING;) {
        const size_t length = numberAt(bytes, at);
        if (length > bytes.size() - at - FRAMING) return false;
        const std::string_view checked = bytes.substr(at + 4, length + 4);
        if (libdeflate_crc32(0, checked.data(), checked.size()) != numberAt(bytes, at + 8 + length)) return false;
        at += FRAMING + length;
        if (checked.starts_with("IEND")) return at == bytes.size();
    }
    return false;
}

}  // namespace

bool isWholePicture(std::string_view bytes, uint32_t width, uint32_t height)
{
    const bool whole = bytes.starts_with(PNG_START) ? areChunksWhole(bytes)
                                                    : bytes.starts_with(JPEG_START) && bytes.ends_with(JPEG_END);
    int columns = 0, rows = 0, channels = 0;
    return whole &&
           stbi_info_from_memory(reinterpret_cast<const stbi_uc*>(bytes.data()), static_cast<int>(bytes.size()),
                                 &columns, &rows, &channels) != 0 &&
           static_cast<uint32_t>(columns) == width && static_cast<uint32_t>(rows) == height;
}

}  // namespace knuckle
