#include "app/states/block_pack.h"

#include <libdeflate.h>
#include <zstd.h>

#include <bit>
#include <cstring>
#include <memory>
#include <stdexcept>

namespace knuckle {

namespace {

static_assert(std::endian::native == std::endian::little, "files of blocks hold numbers as they lie in memory");

constexpr std::string_view MAGIC("knuckle blocks\r\n", 16);
constexpr uint32_t BLOCK_MARK = 0x314b4c42, END_MARK = 0x31444e45;  // "BLK1", "END1"
enum Encoding : uint32_t { PLAIN, PACKED, PACKED_PLANES };
/// Level 1 packs as fast as a state is read from a GPU; higher ones gain a few percent.
constexpr int LEVEL = 1, QUICK_LEVEL = -20;
constexpr size_t WORD = 4;

template <typename T>
void put(std::array<char, BlockHeader::SIZE>& out, size_t offset, T value)
{
    std::memcpy(out.data() + offset, &value, sizeof value);
}

template <typename T>
T get(std::string_view text, size_t offset)
{
    T value{};
    std::memcpy(&value, text.data() + offset, sizeof value);
    return value;
}

/// Byte k of every word, then byte k + 1: exponents of floats stand together, and repeat.
std::vector<char> toPlanes(std::span<const std::byte> bytes)
{
    const size_t words = bytes.size() / WORD;
    std::vector<char> planes(bytes.size());
    for (size_t k = 0; k < WORD; ++k)
        for (size_t i = 0; i < words; ++i) planes[k * words + i] = static_cast<char>(bytes[WORD * i + k]);
    return planes;
}

std::vector<std::byte> fromPlanes(const std::vector<std::byte>& planes)
{
    const size_t words = planes.size() / WORD;
    std::vector<std::byte> bytes(planes.size());
    for (size_t k = 0; k < WORD; ++k)
        for (size_t i = 0; i < words; ++i) bytes[WORD * i + k] = planes[k * words + i];
    return bytes;
}

}  // namespace

std::array<char, BlockHeader::SIZE> BlockHeader::write() const
{
    std::array<char, SIZE> out{};
    put(out, 0, isEnd ? END_MARK : BLOCK_MARK);
    put(out, 4, nameBytes);
    put(out, 8, encoding);
    put(out, 12, checksum);
    put(out, 16, stored);
    put(out, 24, bytes);
    put(out, SIZE - 4, crc32({out.data(), SIZE - 4}));
    return out;
}

std::optional<BlockHeader> BlockHeader::read(std::string_view text)
{
    const auto mark = get<uint32_t>(text, 0);
    if (get<uint32_t>(text, SIZE - 4) != crc32(text.substr(0, SIZE - 4))) return {};
    if (mark != BLOCK_MARK && mark != END_MARK) return {};
    BlockHeader header;
    header.isEnd = mark == END_MARK;
    header.nameBytes = get<uint32_t>(text, 4);
    header.encoding = get<uint32_t>(text, 8);
    header.checksum = get<uint32_t>(text, 12);
    header.stored = get<uint64_t>(text, 16);
    header.bytes = get<uint64_t>(text, 24);
    if (header.nameBytes > MAX_NAME) return {};
    return header;
}

std::string fileStart()
{
    std::string text(MAGIC);
    const auto append = [&](uint32_t word) { text.append(reinterpret_cast<const char*>(&word), sizeof word); };
    append(BLOCK_FILE_VERSION);
    append(crc32(text));
    return text;
}

std::string packBlock(std::string_view name, std::span<const std::byte> bytes, BlockKind kind)
{
    if (name.size() > BlockHeader::MAX_NAME) throw std::logic_error("the name of a block is too long");
    const bool byPlane = kind == BlockKind::Words;
    const std::vector<char> planes = byPlane ? toPlanes(bytes) : std::vector<char>();
    const void* source = byPlane ? static_cast<const void*>(planes.data()) : bytes.data();
    const size_t room = ZSTD_compressBound(bytes.size());
    const auto buffer = std::make_unique_for_overwrite<char[]>(room);
    const int level = kind == BlockKind::Quick ? QUICK_LEVEL : LEVEL;
    const size_t size = ZSTD_compress(buffer.get(), room, source, bytes.size(), level);
    BlockHeader header;
    header.nameBytes = static_cast<uint32_t>(name.size());
    header.bytes = bytes.size();
    const bool smaller = ZSTD_isError(size) == 0 && size < bytes.size();
    if (smaller) header.encoding = byPlane ? PACKED_PLANES : PACKED;
    const std::string_view packed = smaller
                                        ? std::string_view(buffer.get(), size)
                                        : std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    header.stored = packed.size();
    header.checksum = crc32(packed, crc32(name));
    const std::array<char, BlockHeader::SIZE> start = header.write();
    std::string block;
    block.reserve(start.size() + name.size() + packed.size());
    return block.append(start.data(), start.size()).append(name).append(packed);
}

std::string packText(std::string_view name, std::string_view text)
{
    return packBlock(name, std::as_bytes(std::span(text)), BlockKind::Text);
}

std::string packEnd(uint64_t blocks)
{
    BlockHeader header;
    header.isEnd = true;
    header.bytes = blocks;
    const std::array<char, BlockHeader::SIZE> text = header.write();
    return {text.data(), text.size()};
}

std::optional<std::vector<std::byte>> unpackBlock(const BlockHeader& header, std::string_view stored)
{
    const auto* begin = reinterpret_cast<const std::byte*>(stored.data());
    if (header.encoding == PLAIN) {
        if (stored.size() != header.bytes) return {};
        return std::vector<std::byte>(begin, begin + stored.size());
    }
    // Checked before room is made for it: a wrong size must not ask for all memory.
    const unsigned long long said = ZSTD_getFrameContentSize(stored.data(), stored.size());
    if (header.encoding > PACKED_PLANES || said != header.bytes) return {};
    std::vector<std::byte> bytes(header.bytes);
    const size_t size = ZSTD_decompress(bytes.data(), bytes.size(), stored.data(), stored.size());
    if (ZSTD_isError(size) != 0 || size != bytes.size()) return {};
    if (header.encoding == PACKED) return bytes;
    if (bytes.size() % WORD != 0) return {};
    return fromPlanes(bytes);
}

uint32_t crc32(std::string_view bytes, uint32_t before)
{
    // The library takes a null pointer for a new sum.
    return bytes.empty() ? before : libdeflate_crc32(before, bytes.data(), bytes.size());
}

}  // namespace knuckle
