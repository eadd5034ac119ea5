#include <gtest/gtest.h>

#include <bit>
#include <random>

#include "app/states/block_file.h"
#include "sim/base/errors.h"
#include "tests/message_of.h"
#include "tests/temp_folder.h"

namespace knuckle::test {
namespace {

using Words = std::vector<uint32_t>;

class BlockFile : public testing::Test {
protected:
    std::string write(const std::vector<std::string>& blocks) const
    {
        std::string path = folder_.path("file.states");
        BlockWriter writer(path);
        for (const std::string& block : blocks) writer.add(block);
        writer.commit();
        return path;
    }
    /// What is said of a file with these bytes; empty if it is taken.
    std::string complaintAbout(const std::string& bytes) const
    {
        const std::string path = folder_.write("tried.states", bytes);
        try {
            const BlockReader reader(path);
        } catch (const InputError& error) {
            const std::string message = error.what();
            EXPECT_TRUE(message.starts_with(path + ": ")) << message;
            EXPECT_EQ(message.find('\n'), std::string::npos);
            return message.substr(path.size() + 2);
        }
        return "";
    }

    TempFolder folder_;
};

Words ramp(size_t count)
{
    Words words(count);
    for (size_t i = 0; i < count; ++i) words[i] = std::bit_cast<uint32_t>(1.0f + 0.001f * static_cast<float>(i));
    return words;
}

Words noise(size_t count)
{
    std::mt19937 random(5);
    Words words(count);
    for (uint32_t& word : words) word = static_cast<uint32_t>(random());
    return words;
}

std::string packWords(const std::string& name, const Words& words)
{
    return packArray(name, std::span<const uint32_t>(words));
}

TEST_F(BlockFile, GivesBackWhatWasWritten)
{
    const Words steady = ramp(10007), wild = noise(313);
    const BlockReader reader(write({packText("words", "a line\nand another"), packWords("steady", steady),
                                    packWords("wild", wild), packWords("none", {}), packText("", "")}));
    ASSERT_EQ(reader.list().size(), 5u);
    EXPECT_EQ(reader.readText("words"), "a line\nand another");
    EXPECT_EQ(reader.readArray<uint32_t>("steady"), steady);
    EXPECT_EQ(reader.readArray<uint32_t>("wild"), wild);
    EXPECT_TRUE(reader.read("none").empty());
    EXPECT_EQ(reader.readText(""), "");
    // A ramp of floats has four bytes a word, of which two hardly change: half is the least that must be saved.
    EXPECT_LT(reader.list()[1].stored, 2u * steady.size());
    EXPECT_LE(reader.list()[2].stored, 4u * wild.size());
}

TEST_F(BlockFile, NamesABlockThatIsNotThereOrHasAnotherSize)
{
    const BlockReader reader(write({packText("odd", "abcde")}));
    EXPECT_FALSE(reader.has("even"));
    EXPECT_EQ(messageOf<InputError>([&] { reader.read("even"); }), reader.path() + ": has no block \"even\"");
    EXPECT_EQ(messageOf<InputError>([&] { reader.readArray<uint32_t>("odd"); }),
              reader.path() + ": block \"odd\" has an odd size");
}

TEST_F(BlockFile, PackedBlocksGoFromOneFileToAnother)
{
    const BlockReader first(write({packWords("steady", ramp(101)), packText("words", "as they are")}));
    const std::string path = folder_.path("second.states");
    BlockWriter second(path);
    for (const auto& block : first.list()) second.add(first.readPacked(block.name));
    second.commit();
    EXPECT_EQ(readText(path), readText(first.path()));
}

TEST_F(BlockFile, IsRefusedWithAnyBitChanged)
{
    const std::string whole = readText(write({packText("words", "short"), packWords("steady", ramp(37))}));
    ASSERT_EQ(complaintAbout(whole), "");
    for (size_t bit = 0; bit < 8 * whole.size(); ++bit) {
        std::string changed = whole;
        changed[bit / 8] = static_cast<char>(changed[bit / 8] ^ (1 << bit % 8));
        ASSERT_NE(complaintAbout(changed), "") << "bit " << bit % 8 << " of byte " << bit / 8;
    }
}

TEST_F(BlockFile, IsRefusedAtAnyOtherLength)
{
    const std::string whole = readText(write({packText("words", "short"), packWords("steady", ramp(37))}));
    for (size_t length = 0; length < whole.size(); ++length)
        ASSERT_NE(complaintAbout(whole.substr(0, length)), "") << length << " bytes";
    EXPECT_NE(complaintAbout(whole + '\0'), "");
    EXPECT_NE(complaintAbout(whole + whole), "");
}

TEST_F(BlockFile, SaysWhatIsWrong)
{
    const std::string whole = readText(write({packText("words", "short")}));
    EXPECT_EQ(complaintAbout(""), "is empty");
    EXPECT_EQ(complaintAbout("{ \"duration\": 3 }"),
              "is not a file of states, as --record and --save-state write them");
    EXPECT_EQ(complaintAbout(whole.substr(0, 20)), "ends within its first bytes; it was cut, make it anew");
    EXPECT_EQ(complaintAbout(whole.substr(0, 60)), "ends after 60 bytes, before its end mark; it was cut");
    // A newer version: its number and the checksum of what stands before.
    std::string newer = whole;
    newer[16] = static_cast<char>(BLOCK_FILE_VERSION + 1);
    const uint32_t checksum = crc32({newer.data(), 20});
    newer.replace(20, 4, reinterpret_cast<const char*>(&checksum), 4);
    EXPECT_EQ(complaintAbout(newer),
              "is of version 2, and this program reads version 1; use the program that wrote it");
    EXPECT_EQ(messageOf<InputError>([&] { const BlockReader reader(folder_.path("no.states")); }),
              folder_.path("no.states") + ": cannot be read: No such file or directory");
    EXPECT_EQ(messageOf<InputError>([&] { const BlockReader reader(folder_.path()); }),
              folder_.path() + ": is not a regular file; name a file of states");
}

TEST_F(BlockFile, IsRefusedWithABlockTwice)
{
    EXPECT_NE(complaintAbout(readText(write({packText("words", "one"), packText("words", "two")}))), "");
}

TEST_F(BlockFile, DoesNotAskForTheMemoryThatAWrongHeaderNames)
{
    // A block whose header says 2^39 bytes, with checksums that are right.
    const std::string packed = packText("big", std::string(1000, 'a'));
    auto header = BlockHeader::read(std::string_view(packed).substr(0, BlockHeader::SIZE));
    ASSERT_TRUE(header);
    header->bytes = uint64_t{1} << 39;
    const auto start = header->write();
    const BlockReader reader(write({std::string(start.data(), start.size()) + packed.substr(BlockHeader::SIZE)}));
    EXPECT_EQ(messageOf<InputError>([&] { reader.read("big"); }),
              reader.path() + ": has a block \"big\" that cannot be unpacked");
}

}  // namespace
}  // namespace knuckle::test
