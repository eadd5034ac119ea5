#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace knuckle {

/// Files of named blocks, each compressed and with checksums of its own: every byte of a file is under one of them.
/// docs/states.md has the layout, byte by byte; all numbers are little-endian.

/// Changes whenever a program of before could not read what is written now.
inline constexpr uint32_t BLOCK_FILE_VERSION = 1;
inline constexpr size_t BLOCK_FILE_START = 24;  ///< Bytes of fileStart().

/// What the bytes of a block are, so that they are packed well.
enum class BlockKind : uint32_t {
    Text,   ///< Compressed as they are.
    Words,  ///< Of four bytes: all first bytes are compressed first, then all second ones, ...
    Quick,  ///< As Text, in half the time and less well.
};

/// What stands before a block's name and bytes.
struct BlockHeader {
    static constexpr size_t SIZE = 48;
    static constexpr size_t MAX_NAME = 255;

    bool isEnd = false;  ///< The mark at the end of a file; `bytes` is the number of blocks before it.
    uint32_t nameBytes = 0;
    uint32_t encoding = 0;  ///< 0 as it is, 1 Zstandard, 2 Zstandard of words by byte.
    uint32_t checksum = 0;  ///< CRC-32 of the name and the stored bytes.
    uint64_t stored = 0;    ///< Number of bytes after the name.
    uint64_t bytes = 0;     ///< The same, unpacked.

    std::array<char, SIZE> write() const;
    /// None if its own checksum or its mark is wrong. @param text of SIZE bytes.
    static std::optional<BlockHeader> read(std::string_view text);
};

/// The first bytes of a file: what it is, its version, their checksum.
std::string fileStart();
/// A block as it stands in a file. @param name up to BlockHeader::MAX_NAME bytes. @param bytes of BlockKind::Words a
/// multiple of 4.
std::string packBlock(std::string_view name, std::span<const std::byte> bytes, BlockKind kind);
std::string packText(std::string_view name, std::string_view text);
/// @tparam T made of words, without padding.
template <typename T>
std::string packArray(std::string_view name, std::span<const T> values)
{
    static_assert(sizeof(T) % 4 == 0);
    return packBlock(name, std::as_bytes(values), BlockKind::Words);
}
/// The end mark of a file with that many blocks.
std::string packEnd(uint64_t blocks);
/// The bytes that packBlock() got; none if they do not fit the header. @param stored without the name.
std::optional<std::vector<std::byte>> unpackBlock(const BlockHeader& header, std::string_view stored);
/// CRC-32, as in PNG and zlib.
uint32_t crc32(std::string_view bytes, uint32_t before = 0);

}  // namespace knuckle
