#include <filesystem>
#include <sstream>

#include "app/json/json.h"
#include "render/picture/image.h"
#include "tests/cli/cli_fixture.h"

namespace knuckle {
namespace {

namespace fs = std::filesystem;
using test::RunResult;

/// golden and out with five images each: same.png, sub/little.png and sub/much.png that differ, size.png, and one that
/// only the one folder has.
class CompareFolders : public test::CliTest {
protected:
    CompareFolders()
    {
        for (const char* place : {"golden", "out"}) fs::create_directories(folder.path(place) + "/sub");
        write("golden/same.png", 0);
        write("out/same.png", 0);
        write("golden/sub/little.png", 0);
        write("out/sub/little.png", 4);
        write("golden/sub/much.png", 0);
        write("out/sub/much.png", 12);
        write("golden/size.png", 0);
        write("out/size.png", 0, 20);
        write("golden/gone.png", 0);
        write("out/new.png", 0);
        folder.write("golden/notes.txt", "not an image");
    }
    /// A grey picture with a white box.
    void write(const std::string& name, uint32_t box, uint32_t width = 40) const
    {
        Image image{width, 30, std::vector<uint8_t>(size_t{3} * width * 30, 90)};
        for (uint32_t y = 0; y < box; ++y)
            for (uint32_t i = 0; i < box * 3; ++i) image.rgb[y * width * 3 + i] = 255;
        writePng(folder.path(name), image);
    }
    static std::vector<std::string> linesOf(const std::string& text)
    {
        std::istringstream stream(text);
        std::vector<std::string> lines;
        for (std::string line; std::getline(stream, line);) lines.push_back(line);
        return lines;
    }
    RunResult compare(std::vector<std::string> options) const
    {
        options.insert(options.begin(), {"compare", "golden", "out"});
        return run(options);
    }
};

TEST_F(CompareFolders, TellsTheWorstFirstAndWhatIsMissing)
{
    const RunResult result = compare({});
    EXPECT_EQ(result.code, 4);
    const std::vector<std::string> lines = linesOf(result.out);
    ASSERT_EQ(lines.size(), 6u) << result.out;
    EXPECT_EQ(lines[0], "size.png: different: 40 x 30 against 20 x 30");
    EXPECT_TRUE(lines[1].starts_with("sub/much.png: different: 144 of 1200 pixels differ")) << lines[1];
    EXPECT_TRUE(lines[2].starts_with("sub/little.png: different: 16 of 1200 pixels differ")) << lines[2];
    EXPECT_TRUE(lines[2].ends_with("; the difference is in 1 place, at 0,0, 4 x 4")) << lines[2];
    EXPECT_EQ(lines[3], "gone.png: missing in out");
    EXPECT_EQ(lines[4], "new.png: new, not in golden");
    EXPECT_EQ(lines[5], "3 of 4 images differ, 1 missing, 1 new");
}

TEST_F(CompareFolders, ComparesOnlyNamesThatMatch)
{
    EXPECT_EQ(compare({"--pattern", "same.*"}).code, 0);
    EXPECT_EQ(compare({"--pattern", "same.*"}).out, "0 of 1 images differ\n");
    EXPECT_EQ(linesOf(compare({"--pattern", "sub/*"}).out).back(), "2 of 2 images differ");
    EXPECT_EQ(linesOf(compare({"--pattern", "little.png", "--pattern", "same.png"}).out).back(),
              "1 of 2 images differs");
    expectError(compare({"--pattern", "x*"}), 2, "no images in golden and out; no name matches --pattern");
}

TEST_F(CompareFolders, NewImagesPassWhereTheyAreAllowed)
{
    fs::remove(folder.path("golden/gone.png"));
    const std::vector<std::string> words{"--pattern", "same.png", "--pattern", "new.png", "--pattern", "gone.png"};
    EXPECT_EQ(compare(words).code, 4);
    std::vector<std::string> allowed = words;
    allowed.emplace_back("--allow-new");
    EXPECT_EQ(compare(allowed).code, 0);
    write("golden/gone.png", 0);
    EXPECT_EQ(compare(allowed).code, 4) << "what is missing never passes";
}

TEST_F(CompareFolders, GoesOnAfterWhatCannotBeRead)
{
    folder.write("out/same.png", "broken");
    const RunResult result = compare({});
    EXPECT_EQ(result.code, 2);
    EXPECT_EQ(result.err, "knuckle: image out/same.png cannot be read: it is none of PNG, JPEG and EXR; convert it to "
                          "one of them\n");
    EXPECT_EQ(linesOf(result.out).back(), "3 of 4 images differ, 1 missing, 1 new, 1 cannot be read");
}

TEST_F(CompareFolders, PrintsJsonAndTakesLimitsByPath)
{
    folder.write("limits.json", R"({ "names": { "sub/*": { "share": 1, "mean": 255, "tile": 1000, "flip": 1 } } })");
    const Json json = parseJson(compare({"--json", "--limits", "limits.json"}).out, "output");
    EXPECT_EQ(json["verdict"], "different");
    EXPECT_EQ(json["missing"], Json({"gone.png"}));
    EXPECT_EQ(json["new"], Json({"new.png"}));
    ASSERT_EQ(json["images"].size(), 4u);
    EXPECT_EQ(json["images"][0]["name"], "size.png");
    EXPECT_EQ(json["images"][0]["secondWidth"], 20);
    for (size_t i = 1; i < 4; ++i) EXPECT_EQ(json["images"][i]["verdict"], "equal");
}

TEST_F(CompareFolders, WritesPicturesOfWhatDiffers)
{
    EXPECT_EQ(compare({"--difference", "failures", "--heatmap", "heat/"}).code, 4);
    EXPECT_EQ(test::listFolder(folder.path("failures")),
              (std::vector<std::string>{"sub", "sub/little.png", "sub/much.png"}));
    EXPECT_TRUE(fs::exists(folder.path("heat/sub/much.png")));
    expectError(compare({"--difference", "golden/failures"}), 2,
                "--difference golden/failures lies in golden, which is compared; name another folder");
}

TEST_F(CompareFolders, RefusesFoldersWithoutImages)
{
    fs::create_directories(folder.path("empty"));
    expectError(run({"compare", "empty", "empty"}), 2,
                "no images in empty and empty; PNG, JPEG and EXR are compared, by their endings");
    EXPECT_EQ(run({"compare", "golden", "empty"}).code, 4) << "all are missing";
}

}  // namespace
}  // namespace knuckle
