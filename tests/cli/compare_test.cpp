#include <filesystem>
#include <map>

#include "app/json/json.h"
#include "render/picture/image.h"
#include "tests/cli/cli_fixture.h"

namespace knuckle {
namespace {

using test::RunResult;

/// grey.png of 64 x 48 and changed.png with a box of 10 x 10 at 20,10 in it.
class Compare : public test::CliTest {
protected:
    Compare()
    {
        Image image = grey(64, 48);
        writePng(folder.path("grey.png"), image);
        for (uint32_t y = 10; y < 20; ++y)
            for (uint32_t x = 20; x < 30; ++x) image.rgb[(y * 64 + x) * 3] = 250;
        writePng(folder.path("changed.png"), image);
    }
    static Image grey(uint32_t width, uint32_t height)
    {
        return {width, height, std::vector<uint8_t>(size_t{3} * width * height, 100)};
    }
    RunResult compare(std::vector<std::string> options, const std::string& other = "changed.png") const
    {
        options.insert(options.begin(), {"compare", "grey.png", other});
        return run(options);
    }
    void expectRefused(const std::vector<std::string>& options, const std::string& message) const
    {
        expectError(compare(options), 2, message);
    }
};

TEST_F(Compare, TellsWhatDiffersAndWhere)
{
    const RunResult same = compare({}, "grey.png");
    EXPECT_EQ(same.code, 0);
    EXPECT_EQ(same.out, "equal: 3072 pixels compared, none differs\n");
    const RunResult different = compare({});
    EXPECT_EQ(different.code, 4);
    EXPECT_TRUE(
        different.out.starts_with("different: 100 of 3072 pixels differ by more than 8 of 255 (15 may, 0.5 %); "))
        << different.out;
    EXPECT_TRUE(different.out.ends_with("\nthe difference is in 1 place, at 20,10, 10 x 10\n")) << different.out;
    EXPECT_EQ(compare({"--quiet"}).out, "");
    EXPECT_EQ(compare({"--quiet"}).code, 4);
}

TEST_F(Compare, TakesAnotherSizeForADifference)
{
    writePng(folder.path("small.png"), grey(32, 24));
    const RunResult result = compare({"--difference", "d.png"}, "small.png");
    EXPECT_EQ(result.code, 4);
    EXPECT_EQ(result.out, "different: 64 x 48 against 32 x 24\n");
    EXPECT_EQ(result.err, "");
    EXPECT_FALSE(std::filesystem::exists(folder.path("d.png")));
}

TEST_F(Compare, HoldsEachLimitThatIsGiven)
{
    const std::map<std::string, std::string> loose{
        {"--max-changed", "1"}, {"--max-mean", "255"}, {"--max-tile", "1000"}, {"--max-flip", "1"}};
    const auto codeOf = [&](const std::map<std::string, std::string>& given) {
        std::map<std::string, std::string> options = given;
        options.insert(loose.begin(), loose.end());
        // A number of pixels is a limit by itself: the share does not come on top where it is not given.
        if (given.contains("--max-pixels")) options.erase("--max-changed");
        std::vector<std::string> words;
        for (const auto& [option, value] : options) words.insert(words.end(), {option, value});
        return compare(words).code;
    };
    EXPECT_EQ(codeOf({}), 0);
    // 100 of 3072 pixels differ by 150 in red: 0.03255 of them, 1.6276 in the mean of three channels.
    const struct {
        const char *option, *holds, *broken;
    } cases[] = {{"--max-pixels", "100", "99"},  {"--max-changed", "0.0326", "0.0325"},
                 {"--max-mean", "1.63", "1.62"}, {"--max-difference", "150", "149"},
                 {"--max-tile", "200", "10"},    {"--max-flip", "0.9", "0.001"},
                 {"--min-ssim", "-1", "0.999"}};
    for (const auto& entry : cases) {
        EXPECT_EQ(codeOf({{entry.option, entry.holds}}), 0) << entry.option;
        EXPECT_EQ(codeOf({{entry.option, entry.broken}}), 4) << entry.option;
    }
    EXPECT_EQ(codeOf({{"--threshold", "150"}, {"--max-pixels", "0"}}), 0);
    EXPECT_EQ(codeOf({{"--threshold", "149"}, {"--max-pixels", "0"}}), 4);
}

TEST_F(Compare, LeavesOutWhatItIsTold)
{
    Image mask = grey(64, 48);
    for (uint32_t y = 10; y < 20; ++y)
        for (uint32_t x = 20; x < 30; ++x)
            for (size_t c = 0; c < 3; ++c) mask.rgb[(y * 64 + x) * 3 + c] = 0;
    writePng(folder.path("mask.png"), mask);
    const std::vector<std::vector<std::string>> cases{{"--ignore", "20,10,10x10"},
                                                      {"--ignore", "20,10,5x10", "--ignore", "25,10,5x10"},
                                                      {"--mask", "mask.png"},
                                                      {"--ignore-color", "fa6464"},
                                                      {"--ignore-color", "#FA6464"}};
    for (const auto& options : cases) {
        EXPECT_EQ(compare(options).code, 0) << options[1];
        EXPECT_EQ(compare(options).out, "equal: 2972 pixels compared, none differs\n") << options[1];
    }
    EXPECT_EQ(compare({"--ignore", "20,10,5x10"}).code, 4);
    EXPECT_EQ(compare({"--ignore-antialiasing"}).code, 4);
}

TEST_F(Compare, RefusesWordsThatItDoesNotUnderstand)
{
    for (const char* word : {"20,10", "20,10,0x5", "a,b,cxd", "1,2,3x4x5", "-1,2,3x4", "1,2,3 x 4"})
        expectRefused(
            {"--ignore=" + std::string(word)},
            "--ignore " + std::string(word) + ": must be X,Y,WxH in pixels from the top left, such as 10,20,64x32");
    for (const char* word : {"fff", "red", "ff00f", "gg0000"})
        expectRefused({"--ignore-color", word}, "--ignore-color " + std::string(word) +
                                                    ": must be a colour as RRGGBB in hexadecimal, such as ff00ff");
    writePng(folder.path("mask.png"), grey(63, 48));
    expectRefused({"--mask", "mask.png"},
                  "the mask has 63 x 48 pixels, the images 64 x 48; make it as large as they are");
    expectRefused({"--ignore", "0,0,64x48"}, "nothing is left to compare: all pixels are ignored; ignore less");
    expectRefused({"--pattern", "*.png"}, "--pattern and --allow-new are for two folders; name two, or leave them out");
}

TEST_F(Compare, TellsWhatCannotBeRead)
{
    folder.write("text.png", "not an image");
    folder.write("empty.png", "");
    expectError(compare({}, "none.png"), 2, "image none.png cannot be opened: No such file or directory");
    expectError(compare({}, "."), 2, "image . cannot be opened: it is a folder; name a picture in it");
    expectError(compare({}, "empty.png"), 2, "image empty.png cannot be read: it is empty; write it anew");
    expectError(compare({}, "text.png"), 2,
                "image text.png cannot be read: it is none of PNG, JPEG and EXR; convert it to one of them");
    expectError(run({"compare", "text.png", "text.png"}), 2,
                "image text.png cannot be read: it is none of PNG, JPEG and EXR; convert it to one of them");
}

TEST_F(Compare, WritesPicturesOfTheDifference)
{
    EXPECT_EQ(compare({"--difference", "d.png", "--heatmap", "h.png"}).code, 4);
    const Image difference = readImage(folder.path("d.png")), heat = readImage(folder.path("h.png"));
    EXPECT_EQ(difference.rgb[0], 0);
    EXPECT_EQ(difference.rgb[(15 * 64 + 25) * 3], 255);
    EXPECT_EQ(heat.width, 64u);
    EXPECT_GT(heat.rgb[(15 * 64 + 25) * 3], 60);
    EXPECT_EQ(compare({"--difference", "x.png", "--heatmap", "x.png"}).code, 2);
    EXPECT_EQ(compare({"--heatmap", "grey.png"}).code, 2);
    EXPECT_EQ(compare({"--heatmap", "h.jpg"}).code, 2);
    EXPECT_EQ(compare({"--mask", "d.png", "--difference", "./d.png"}).code, 2) << "a mask is an input, too";
}

TEST_F(Compare, PrintsAllFiguresAsJson)
{
    const RunResult result = compare({"--json", "--quiet"});
    EXPECT_EQ(result.code, 4);
    const Json json = parseJson(result.out, "output");
    EXPECT_EQ(json["verdict"], "different");
    EXPECT_EQ(json["second"], "changed.png");
    EXPECT_EQ(json["changed"], 100);
    EXPECT_NEAR(json["channels"]["red"]["largest"].get<double>(), 150, 1e-3);
    EXPECT_EQ(json["channels"]["green"]["largest"], 0.0);
    EXPECT_EQ(json["places"][0]["x"], 20);
    EXPECT_EQ(json["placeCount"], 1);
    EXPECT_EQ(json["flip"]["kind"], "LDR");
    EXPECT_GT(json["flip"]["mean"].get<double>(), 0.001);
    EXPECT_LT(json["ssim"]["mean"].get<double>(), 0.999);
    EXPECT_FALSE(json["reasons"].empty());
}

TEST_F(Compare, TakesLimitsByNameFromAFile)
{
    folder.write("limits.json", R"({ // for this machine
        "default": { "share": 1, "mean": 255, "tile": 1000, "flip": 1 },
        "names": { "gr*.png": { "pixels": 99 }, "grey.png": { "pixels": 100 }, "other.png": { "pixels": 0 } } })");
    EXPECT_EQ(compare({"--limits", "limits.json"}).code, 0);
    const RunResult strict = compare({"--limits", "limits.json", "--max-pixels", "5"});
    EXPECT_EQ(strict.code, 4) << "the command line comes before the file";
    EXPECT_TRUE(strict.out.starts_with("different: 100 of 3072 pixels differ by more than 8 of 255 (5 may)"));
    const std::vector<std::pair<std::string, std::string>> wrong{
        {R"({ "defaults": {} })", "limits.json: /defaults: unknown field; did you mean \"default\"?"},
        {R"({ "names": { "a*": { "flip": 2 } } })", "limits.json: /names/a*/flip: "},
        {R"({ "default": { "pixels": 1.5 } })", "limits.json: /default/pixels: "},
        {R"({ "default": [] })", "limits.json: /default: "},
        {R"({ "default": )", "limits.json:1:"}};
    for (const auto& [text, message] : wrong) {
        folder.write("limits.json", text);
        const RunResult result = compare({"--limits", "limits.json"});
        EXPECT_EQ(result.code, 2) << text;
        EXPECT_TRUE(result.err.starts_with("knuckle: " + message)) << result.err;
        EXPECT_TRUE(test::isOneLine(result.err)) << result.err;
    }
}

}  // namespace
}  // namespace knuckle
