#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "app/states/block_pack.h"
#include "sim/base/files/file_descriptor.h"
#include "sim/base/files/output_file.h"

namespace knuckle {

/// Writes a file of blocks, which gets its name when it is complete.
class BlockWriter {
public:
    /// @throws as OutputFile.
    explicit BlockWriter(const std::string& path);
    /// @param block from packBlock(). @throws RunError (full disk).
    void add(std::string_view block);
    /// Writes the end mark, without which no reader takes the file.
    void commit();
    /// The same, and waits until the file is on the disk under its name.
    void commitDurably();

private:
    OutputFile file_;
    uint64_t count_ = 0;
};

/// Reads a file of blocks. Takes only what is whole: opening it checks every byte.
class BlockReader {
public:
    struct Block {
        std::string name;
        uint64_t bytes = 0;   ///< Unpacked.
        uint64_t stored = 0;  ///< In the file.
    };

    /// @throws InputError, one line with the file, if it is missing, no file of blocks, of a newer version, cut or
    /// damaged.
    explicit BlockReader(const std::string& path);
    /// The first bytes of a file that is still written: whole blocks, without the end mark.
    BlockReader(const std::string& path, uint64_t bytes);
    ~BlockReader();
    BlockReader(const BlockReader&) = delete;
    BlockReader& operator=(const BlockReader&) = delete;

    const std::string& path() const { return path_; }
    const std::vector<Block>& list() const { return blocks_; }
    bool has(std::string_view name) const { return byName_.find(name) != byName_.end(); }
    /// @throws InputError if there is none of that name, or if it has changed since the file was opened.
    std::vector<std::byte> read(std::string_view name) const;
    std::string readText(std::string_view name) const;
    /// @throws InputError also if its size is no multiple of T's.
    template <typename T>
    std::vector<T> readArray(std::string_view name) const
    {
        static_assert(std::is_trivially_copyable_v<T>);
        const std::vector<std::byte> bytes = read(name);
        std::vector<T> values(bytes.size() / sizeof(T));
        if (values.size() * sizeof(T) != bytes.size()) refuse("block \"" + std::string(name) + "\" has an odd size");
        if (!bytes.empty()) std::memcpy(values.data(), bytes.data(), bytes.size());
        return values;
    }
    /// The bytes of a block as they stand in the file, for a BlockWriter.
    std::string readPacked(std::string_view name) const;
    /// @throws InputError that names the file.
    [[noreturn]] void refuse(const std::string& why) const;

private:
    struct Place {
        uint64_t offset = 0;  ///< Of its header.
        BlockHeader header;
    };
    size_t find(std::string_view name) const;
    std::string bytesAt(uint64_t offset, uint64_t count) const;
    void openFile();
    void readHeader();
    /// Checks the block at `offset` and adds it. @returns the offset after it.
    uint64_t readBlock(uint64_t offset);

    std::string path_;
    FileDescriptor file_;
    bool ended_ = false;  ///< The end mark was read.
    uint64_t fileBytes_ = 0;
    std::vector<Block> blocks_;
    std::vector<Place> places_;
    std::map<std::string, size_t, std::less<>> byName_;
};

}  // namespace knuckle
