#include <gtest/gtest.h>

#include "render/reader/picture_file.h"
#include "sim/base/errors.h"
#include "tests/compare/made_files.h"
#include "tests/message_of.h"
#include "tests/temp_folder.h"

namespace knuckle::test {
namespace {

std::string refusalOf(const std::string& bytes)
{
    const std::string message = messageOf<InputError>([&] { decodePicture(bytes, "bad"); });
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    return message;
}

void expectRefused(const std::string& bytes, const std::string& words)
{
    const std::string message = refusalOf(bytes);
    EXPECT_TRUE(message.starts_with("image bad cannot be read: ")) << message;
    EXPECT_NE(message.find(words), std::string::npos) << message;
}

TEST(PictureErrors, CutFilesAreRefusedWhereverTheyEnd)
{
    const std::string png = pngBytes(anyRgb(9, 7)), jpeg = jpegBytes(16, 16, 3, std::vector<uint8_t>(16 * 16 * 3, 60));
    ExrMade made;
    made.width = made.height = 8;
    made.channels = {{"Y", std::vector<float>(64, 1.5f)}};
    const std::string exr = exrBytes(made);
    // Without its last bytes a JPEG lacks only its end mark, which is told as well.
    for (const std::string& bytes : {png, jpeg, exr})
        for (size_t size = 4; size < bytes.size(); ++size)
            ASSERT_NE(refusalOf(bytes.substr(0, size)), "") << size << " of " << bytes.size();
}

TEST(PictureErrors, DamageIsToldByItsSum)
{
    std::string bytes = pngBytes(anyRgb(9, 7));
    // The sum itself is before the last chunk, which has 12 bytes.
    bytes[bytes.size() - 13] = static_cast<char>(bytes[bytes.size() - 13] ^ 1);
    expectRefused(bytes, "IDAT: CRC error; the file is damaged, write it anew");
    // A chunk that is not needed for the pixels is no less damaged.
    PngMade made = anyRgb(2, 2);
    made.latinText = {{"Title", "abcdef"}};
    bytes = pngBytes(made);
    bytes[bytes.find("abcdef")] = 'x';
    expectRefused(bytes, "CRC");
}

TEST(PictureErrors, HugeSizesAreRefusedBeforeMemoryIsTaken)
{
    PngMade made;
    made.width = made.height = 30000;
    made.type = 0;
    made.bits = 1;
    made.rows.assign(30000, std::vector<uint8_t>(3750));
    expectRefused(pngBytes(made), "30000 x 30000 pixels are more than the 134217728 that fit");
}

TEST(PictureErrors, OtherFilesAndNoFilesAreTold)
{
    const TempFolder folder;
    expectRefused("GIF89a...", "it is none of PNG, JPEG and EXR");
    expectRefused("\x89PN", "it is none of PNG, JPEG and EXR");
    const auto reading = [](const std::string& path) { return messageOf<InputError>([&] { readPicture(path); }); };
    EXPECT_NE(reading(folder.path()).find("it is a folder"), std::string::npos) << reading(folder.path());
    EXPECT_NE(reading(folder.write("empty.png", "")).find("it is empty"), std::string::npos);
    EXPECT_NE(reading(folder.path("none.png")).find("No such file"), std::string::npos);
}

TEST(PictureErrors, ExrWithoutColorsIsRefused)
{
    ExrMade made;
    made.channels = {{"Z", {1.0f}}};
    expectRefused(exrBytes(made), "it has no channel R, G, B or Y");
}

TEST(PictureErrors, OnePixelIsEnough)
{
    EXPECT_EQ(decodePicture(pngBytes(anyRgb(1, 1)), "a").pixelCount(), 1u);
    EXPECT_EQ(decodePicture(jpegBytes(1, 1, 1, {9}), "a").pixelCount(), 1u);
}

}  // namespace
}  // namespace knuckle::test
