#include <gtest/gtest.h>

#include <filesystem>
#include <limits>
#include <regex>
#include <set>

#include "app/report/report_page.h"
#include "render/reader/picture_file.h"
#include "sim/base/base64.h"
#include "tests/compare/made_pictures.h"
#include "tests/report/made_entries.h"
#include "tests/temp_folder.h"

namespace knuckle {
namespace {

using Status = ReportEntry::Status;

std::string pageOf(const std::vector<ReportEntry>& entries, const ReportHead& head = {"a title", {}})
{
    const test::TempFolder folder;
    writeReport(folder.path("report.html"), head, entries);
    return test::readText(folder.path("report.html"));
}

/// The part of a page that comes before its script: the table.
std::string tableOf(const std::string& page)
{
    const size_t start = page.find("<table id=\"images\">");
    return page.substr(start, page.find("<script>", start) - start);
}

/// The pictures of a page, decoded.
std::vector<Picture> picturesOf(const std::string& page)
{
    constexpr std::string_view START = "src=\"data:image/png;base64,";
    std::vector<Picture> pictures;
    for (size_t i = page.find(START); i != std::string::npos; i = page.find(START, i + 1)) {
        const size_t text = i + START.size();
        const std::string bytes = fromBase64(std::string_view(page).substr(text, page.find('"', text) - text));
        pictures.push_back(decodePicture(bytes, "picture"));
    }
    return pictures;
}

TEST(ReportPage, EmbedsEveryPicture)
{
    const Picture reference = test::madeScene(), output = test::madeSceneWithBox(40, 20, 30, 30);
    const std::string page = pageOf({test::madeEntry("a.png", reference, output),
                                     test::madeEntry("size.png", reference, test::flatPicture(8, 8, {1, 2, 3})),
                                     test::madeSingle("gone.png", reference, Status::Missing),
                                     test::madeSingle("more.png", output, Status::New),
                                     test::madeEntry("same.png", reference, reference)});
    const std::vector<Picture> pictures = picturesOf(page);
    ASSERT_EQ(pictures.size(), 4u + 2u + 1u + 1u);
    EXPECT_EQ(pictures[0].rgba, reference.rgba);
    EXPECT_EQ(pictures[1].rgba, output.rgba);
    EXPECT_EQ(pictures[2].rgba[(30 * 160 + 50) * 4], 1.0f) << "the difference of white and dark, brightened";
    EXPECT_EQ(pictures[2].rgba[0], 0.0f);
    EXPECT_EQ(pictures[5].width, 8u);
    EXPECT_EQ(pictures[6].rgba, reference.rgba);
    EXPECT_EQ(pictures[7].rgba, output.rgba);
    EXPECT_NE(page.find("no pictures: equal"), std::string::npos);
    EXPECT_NE(page.find("2 of 3 images differ, 1 missing, 1 new"), std::string::npos);
    EXPECT_NE(page.find("<li data-box=\"40 20 30 30\">at 40,20, 30 x 30: 900 pixels</li>"), std::string::npos);
}

TEST(ReportPage, ShowsTransparencyAndWhatIsBeyondWhite)
{
    Picture picture = test::flatPicture(2, 1, {100, 200, 50});
    picture.hasAlpha = true;
    // Half transparent, and nothing at all; colours are multiplied by alpha.
    for (size_t c = 0; c < 4; ++c) {
        picture.rgba[c] *= 128.0f / 255.0f;
        picture.rgba[4 + c] = 0.0f;
    }
    const Picture shown = picturesOf(pageOf({test::madeSingle("a.png", picture, Status::New)})).at(0);
    EXPECT_TRUE(shown.hasAlpha);
    for (size_t i = 0; i < 8; ++i) EXPECT_NEAR(shown.rgba[i], picture.rgba[i], 1e-3) << i;
    Picture light = test::flatPicture(1, 1, {0, 0, 0});
    light.hdr = true;
    light.rgba = {7.5f, -1.0f, std::numeric_limits<float>::quiet_NaN(), 1.0f};
    const Picture cut = picturesOf(pageOf({test::madeSingle("a.exr", light, Status::New)})).at(0);
    EXPECT_EQ(cut.rgba, (std::vector<float>{1.0f, 0.0f, 0.0f, 1.0f}));
}

TEST(ReportPage, IsWellFormedWhateverNamesSay)
{
    std::vector<ReportEntry> entries;
    for (const std::string& name : test::oddNames()) {
        entries.push_back(test::madeEntry(name, test::madeScene(), test::madeSceneWithBox(5, 5, 9, 9)));
        entries.back().notes = {{name, name}};
        entries.push_back(test::madeSingle(name, test::madeScene(), Status::Missing));
        entries.back().line = name;
    }
    const std::string plain = pageOf({entries.begin(), entries.begin() + 2}, {"plain", {}});
    const std::string page = pageOf(entries, {"</title>" + test::oddNames()[0], {{"<b>", "</dl>"}}});
    EXPECT_EQ(test::markupProblem(page, true), "");
    EXPECT_EQ(picturesOf(page).size(), entries.size() / 2 * 5);
    const std::string table = tableOf(page);
    EXPECT_EQ(test::countOf(page, "<script"), 1u) << "the page's own";
    EXPECT_EQ(test::countOf(table, "<tr id="), entries.size());
    EXPECT_EQ(test::countOf(page, "</title>"), 1u);
    EXPECT_NE(page.find("&lt;script&gt;window.broken = true&lt;/script&gt;.png"), std::string::npos);
    EXPECT_NE(page.find("two&#10;lines&#9;and\uFFFD bytes ÿþ.png"), std::string::npos);
    EXPECT_NE(page.find("{{rows}}&amp;lt;&amp;amp;.png"), std::string::npos) << "put in as it is";
    // No attribute but those that every page has.
    const auto attributesOf = [](const std::string& text) {
        std::set<std::string> names;
        const std::regex tag("<[a-z][^>\"]*(?:\"[^\"]*\"[^>\"]*)*>"), attribute(" ([a-z-]+)=\"[^\"]*\"");
        for (std::sregex_iterator i(text.begin(), text.end(), tag), end; i != end; ++i) {
            const std::string found = i->str().substr(0, 300);
            for (std::sregex_iterator k(found.begin(), found.end(), attribute); k != end; ++k) names.insert((*k)[1]);
        }
        return names;
    };
    // Without the pictures, for the sake of std::regex.
    const auto withoutData = [](std::string text) {
        for (size_t i = text.find("base64,"); i != std::string::npos; i = text.find("base64,", i + 1))
            text.erase(i + 7, text.find('"', i) - i - 7);
        return text;
    };
    EXPECT_EQ(attributesOf(withoutData(table)), attributesOf(withoutData(tableOf(plain))));
}

TEST(ReportPage, NeedsNothingBesideIt)
{
    const std::string page = pageOf({test::madeEntry("a.png", test::madeScene(), test::madeSceneWithBox(5, 5, 9, 9))});
    for (const char* part : {"http:", "https:", "//cdn", "url(", "@import", "href=", "<link", "<iframe", "fetch(",
                             "XMLHttpRequest", "import(", "eval("})
        EXPECT_EQ(page.find(part), std::string::npos) << part;
    EXPECT_EQ(test::countOf(page, "src="), test::countOf(page, "src=\"data:image/png;base64,"));
    EXPECT_NE(page.find("default-src 'none'"), std::string::npos);
    EXPECT_EQ(page.find("{{"), std::string::npos) << "all places are filled";
    EXPECT_NE(page.find("linear-gradient(to right, rgb(0 0 4), "), std::string::npos);
    EXPECT_NE(page.find("const GAIN = 8;"), std::string::npos);
}

TEST(ReportPage, HasAllFiguresWithoutAScript)
{
    ReportEntry entry = test::madeEntry("a.png", test::madeScene(), test::madeSceneWithBox(40, 20, 30, 30));
    entry.notes = {{"driver of the reference", "llvmpipe"}};
    const std::string table = tableOf(pageOf({entry}));
    for (const char* name :
         {"driver of the reference", "size", "compared pixels", "differing pixels", "changed pixels", "changed share",
          "threshold", "mean", "largest", "red", "green", "blue", "alpha", "worst tile", "FLIP", "SSIM", "places"})
        EXPECT_EQ(test::countOf(table, "<dt>" + std::string(name) + "</dt>"), 1u) << name;
    EXPECT_NE(table.find("<dt>changed pixels</dt><dd><bdi>900</bdi></dd>"), std::string::npos);
    EXPECT_NE(table.find("<bdi>llvmpipe</bdi>"), std::string::npos);
}

TEST(ReportPage, SaysWhatWasLeftOut)
{
    ReportEntry entry = test::madeEntry("a.png", test::madeScene(), test::madeSceneWithBox(40, 20, 30, 30));
    entry.pictures = {};
    entry.leftOutBytes = 3'000'000;
    const std::string page = pageOf({entry});
    EXPECT_NE(page.find("Pictures of the last image that has any are left out: the report would have 4 MB more."),
              std::string::npos);
    EXPECT_NE(page.find("no pictures: the report would be too large"), std::string::npos);
    EXPECT_EQ(pictureBytesOf(4.0), 3'000'000u);
}

TEST(ReportPage, IsNoFileBeforeItIsComplete)
{
    const test::TempFolder folder;
    {
        OutputFile file(folder.path("report.html"));
        writeReport(file, {"title", {}}, {});
        EXPECT_FALSE(std::filesystem::exists(folder.path("report.html")));
    }
    EXPECT_FALSE(std::filesystem::exists(folder.path("report.html")));
    EXPECT_EQ(test::markupProblem(pageOf({}), true), "");
}

}  // namespace
}  // namespace knuckle
