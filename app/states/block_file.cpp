#include "app/states/block_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>

#include "sim/base/errors.h"

namespace knuckle {

namespace {

constexpr uint64_t PIECE = uint64_t{1} << 20;  // bytes read at once
/// More than any device's memory: what a header says beyond this is no size.
constexpr uint64_t MOST_BYTES = uint64_t{1} << 40;

}  // namespace

BlockWriter::BlockWriter(const std::string& path) : file_(path)
{
    file_.write(fileStart());
}

void BlockWriter::add(std::string_view block)
{
    file_.write(block);
    ++count_;
}

void BlockWriter::commit()
{
    file_.write(packEnd(count_));
    file_.commit();
}

void BlockWriter::commitDurably()
{
    file_.write(packEnd(count_));
    file_.commitDurably();
}

BlockReader::BlockReader(const std::string& path) : path_(path)
{
    openFile();
    for (uint64_t offset = BLOCK_FILE_START; !ended_;) offset = readBlock(offset);
}

BlockReader::BlockReader(const std::string& path, uint64_t bytes) : path_(path)
{
    openFile();
    if (fileBytes_ < bytes) refuse(fmt::format("ends after {} bytes of {}; it was cut", fileBytes_, bytes));
    fileBytes_ = bytes;
    uint64_t offset = BLOCK_FILE_START;
    while (offset < bytes && !ended_) offset = readBlock(offset);
    if (ended_) refuse("ends too early; make it anew");
}

BlockReader::~BlockReader() = default;

void BlockReader::openFile()
{
    file_ = FileDescriptor(open(path_.c_str(), O_RDONLY | O_CLOEXEC));
    struct stat facts = {};
    if (file_.get() < 0 || fstat(file_.get(), &facts) != 0)
        refuse(fmt::format("cannot be read: {}", std::strerror(errno)));
    if (!S_ISREG(facts.st_mode)) refuse("is not a regular file; name a file of states");
    fileBytes_ = static_cast<uint64_t>(facts.st_size);
    readHeader();
}

void BlockReader::readHeader()
{
    const std::string wanted = fileStart();
    const size_t magic = wanted.size() - 2 * sizeof(uint32_t), checked = wanted.size() - sizeof(uint32_t);
    if (fileBytes_ == 0) refuse("is empty");
    const std::string found = bytesAt(0, std::min<uint64_t>(fileBytes_, wanted.size()));
    if (found == wanted) return;
    if (found.substr(0, magic) != wanted.substr(0, std::min(magic, found.size())))
        refuse("is not a file of states, as --record and --save-state write them");
    if (found.size() < wanted.size()) refuse("ends within its first bytes; it was cut, make it anew");
    uint32_t version = 0, checksum = 0;
    std::memcpy(&version, found.data() + magic, sizeof version);
    std::memcpy(&checksum, found.data() + checked, sizeof checksum);
    if (checksum != crc32({found.data(), checked})) refuse("is damaged in its first bytes; make it anew");
    refuse(fmt::format("is of version {}, and this program reads version {}; use the program that wrote it", version,
                       BLOCK_FILE_VERSION));
}

uint64_t BlockReader::readBlock(uint64_t offset)
{
    const auto cut = [&] { refuse(fmt::format("ends after {} bytes, before its end mark; it was cut", fileBytes_)); };
    if (fileBytes_ - offset < BlockHeader::SIZE) cut();
    const auto header = BlockHeader::read(bytesAt(offset, BlockHeader::SIZE));
    if (!header || header->bytes > MOST_BYTES || header->stored > MOST_BYTES)
        refuse(fmt::format("is damaged at byte {}; make it anew", offset));
    const uint64_t nameAt = offset + BlockHeader::SIZE, next = nameAt + header->nameBytes + header->stored;
    if (header->isEnd) {
        if (header->bytes != blocks_.size() || nameAt != fileBytes_)
            refuse("has other bytes after its end mark, or lacks blocks; make it anew");
        ended_ = true;
        return nameAt;
    }
    if (next > fileBytes_) cut();
    uint32_t checksum = 0;
    for (uint64_t at = nameAt; at < next; at += std::min(PIECE, next - at))
        checksum = crc32(bytesAt(at, std::min(PIECE, next - at)), checksum);
    const std::string name = bytesAt(nameAt, header->nameBytes);
    if (checksum != header->checksum || !byName_.emplace(name, blocks_.size()).second)
        refuse(fmt::format("is damaged between bytes {} and {}; make it anew", offset, next));
    blocks_.push_back({name, header->bytes, header->stored});
    places_.push_back({offset, *header});
    return next;
}

size_t BlockReader::find(std::string_view name) const
{
    const auto found = byName_.find(name);
    if (found == byName_.end()) refuse(fmt::format("has no block \"{}\"", name));
    return found->second;
}

std::vector<std::byte> BlockReader::read(std::string_view name) const
{
    const Place& place = places_[find(name)];
    const std::string stored = bytesAt(place.offset + BlockHeader::SIZE, place.header.nameBytes + place.header.stored);
    if (crc32(stored) != place.header.checksum) refuse("was changed while it was read");
    auto bytes = unpackBlock(place.header, std::string_view(stored).substr(place.header.nameBytes));
    if (!bytes) refuse(fmt::format("has a block \"{}\" that cannot be unpacked", name));
    return std::move(*bytes);
}

std::string BlockReader::readText(std::string_view name) const
{
    const std::vector<std::byte> bytes = read(name);
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

std::string BlockReader::readPacked(std::string_view name) const
{
    const Place& place = places_[find(name)];
    return bytesAt(place.offset, BlockHeader::SIZE + place.header.nameBytes + place.header.stored);
}

std::string BlockReader::bytesAt(uint64_t offset, uint64_t count) const
{
    std::string bytes(count, '\0');
    for (uint64_t done = 0; done < count;) {
        const ssize_t got = pread(file_.get(), bytes.data() + done, count - done, static_cast<off_t>(offset + done));
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) refuse(got < 0 ? fmt::format("cannot be read: {}", std::strerror(errno)) : "was cut while read");
        done += static_cast<uint64_t>(got);
    }
    return bytes;
}

void BlockReader::refuse(const std::string& why) const
{
    throw InputError(path_ + ": " + why);
}

}  // namespace knuckle
