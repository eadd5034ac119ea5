#include <gtest/gtest.h>

#include <algorithm>

#include "app/report/annotations.h"
#include "app/report/entry_list.h"
#include "app/report/junit.h"
#include "app/report/markup.h"
#include "sim/base/base64.h"
#include "tests/compare/made_pictures.h"
#include "tests/report/made_entries.h"

namespace knuckle {
namespace {

using Status = ReportEntry::Status;

ReportEntry plainEntry(const std::string& name, Status status, double tile = 0.0, size_t pictureBytes = 0)
{
    ReportEntry entry;
    entry.name = name;
    entry.status = status;
    entry.line = "line of " + name;
    entry.comparison.tile.score = tile;
    entry.pictures.output.assign(pictureBytes, 'x');
    return entry;
}

TEST(Markup, EscapesAllThatHasAMeaning)
{
    EXPECT_EQ(escapedMarkup("a<b>&\"'\t\n\r"), "a&lt;b&gt;&amp;&quot;&#39;&#9;&#10;&#13;");
    EXPECT_EQ(escapedMarkup(std::string_view("\0\x1f\x7f", 3)), "\uFFFD\uFFFD\uFFFD");
    EXPECT_EQ(escapedMarkup("größer ≥ 🙂"), "größer ≥ 🙂");
    EXPECT_EQ(escapedMarkup("\xff \xc3"), "ÿ Ã") << "invalid bytes are Latin-1";
    EXPECT_EQ(escapedMarkup("a\xEF\xBF\xBF\xEF\xBF\xBE\xEF\xBF\xBD"), "a\uFFFD\uFFFD\uFFFD") << "no characters of XML";
}

TEST(Markup, WritesBase64)
{
    EXPECT_EQ(toBase64(""), "");
    EXPECT_EQ(toBase64("f"), "Zg==");
    EXPECT_EQ(toBase64("fo"), "Zm8=");
    EXPECT_EQ(toBase64("foo"), "Zm9v");
    EXPECT_EQ(toBase64("foobar"), "Zm9vYmFy");
    EXPECT_EQ(toBase64("\xff\xfe\xfb\xf0"), "//778A==");
}

TEST(ReportEntries, StandWithTheWorstFirst)
{
    ReportEntry size = plainEntry("size", Status::Different);
    size.comparison.width = 1;
    ReportEntry seen = plainEntry("seen", Status::Different, 5);
    seen.comparison.flip.mean = 0.5;
    std::vector<ReportEntry> entries{size,
                                     plainEntry("much", Status::Different, 9),
                                     seen,
                                     plainEntry("a little", Status::Different, 5),
                                     plainEntry("b little", Status::Different, 5),
                                     plainEntry("bad", Status::Unreadable),
                                     plainEntry("gone", Status::Missing),
                                     plainEntry("more", Status::New),
                                     plainEntry("same", Status::Equal)};
    std::vector<std::string> wanted;
    for (const ReportEntry& entry : entries) wanted.push_back(entry.name);
    EntryList list(0);
    for (auto entry = entries.rbegin(); entry != entries.rend(); ++entry) list.add(*entry);
    std::vector<std::string> found;
    for (const ReportEntry& entry : list.take()) found.push_back(entry.name);
    EXPECT_EQ(found, wanted);
    EXPECT_EQ(summaryOf(entries), "5 of 7 images differ, 1 missing, 1 new, 1 cannot be read");
    entries[7].allowed = true;
    EXPECT_EQ(summaryOf(entries), "5 of 7 images differ, 1 missing, 1 new (allowed), 1 cannot be read");
    EXPECT_EQ(summaryOf({size}), "1 of 1 images differs");
}

TEST(ReportEntries, KeepPicturesOfTheWorstOnly)
{
    // 10, 20, ... bytes, the smallest being the worst: 10 + 20 + 30 + 40 fit.
    std::vector<double> scores{9, 8, 7, 6, 5, 4, 3, 2, 1};
    const auto keptOf = [&](const std::vector<double>& order) {
        EntryList list(109);
        for (const double score : order)
            list.add(plainEntry("name", Status::Different, score, static_cast<size_t>((10 - score) * 10)));
        std::vector<size_t> kept;
        for (const ReportEntry& entry : list.take()) {
            kept.push_back(entry.pictures.bytes());
            EXPECT_TRUE(entry.leftOutBytes == 0 || entry.pictures.output.capacity() < 20) << "memory is freed";
            EXPECT_EQ(entry.pictures.bytes() + entry.leftOutBytes,
                      static_cast<size_t>((10 - entry.comparison.tile.score) * 10));
        }
        return kept;
    };
    const std::vector<size_t> wanted{10, 20, 30, 40, 0, 0, 0, 0, 0};
    EXPECT_EQ(keptOf(scores), wanted);
    std::ranges::sort(scores);
    EXPECT_EQ(keptOf(scores), wanted) << "the best first";
    EXPECT_EQ(keptOf({5, 1, 9, 3, 7, 2, 8, 4, 6}), wanted);
}

TEST(Junit, HasACaseForEachImage)
{
    ReportEntry allowed = plainEntry("allowed", Status::New);
    allowed.allowed = true;
    ReportEntry different = test::madeEntry("a.png", test::madeScene(), test::madeSceneWithBox(40, 20, 30, 30));
    different.notes = {{"driver", "llvmpipe"}};
    const std::string xml = junitOf(
        "suite", {different, plainEntry("bad", Status::Unreadable), plainEntry("gone", Status::Missing), allowed,
                  plainEntry("same", Status::Equal)});
    EXPECT_TRUE(xml.starts_with("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites tests=\"5\" failures=\"2\" "
                                "errors=\"1\">\n  <testsuite name=\"suite\" tests=\"5\""))
        << xml;
    EXPECT_EQ(test::markupProblem(xml, false), "");
    EXPECT_EQ(test::countOf(xml, "<testcase classname=\"suite\" name="), 5u);
    EXPECT_EQ(test::countOf(xml, "<failure"), 2u);
    EXPECT_NE(xml.find("<error type=\"unreadable\" message=\"line of bad\">line of bad</error>"), std::string::npos);
    EXPECT_NE(xml.find("<failure type=\"different\" message=\"different: 900 of 14400 pixels differ"),
              std::string::npos);
    EXPECT_NE(xml.find("<property name=\"changed pixels\" value=\"900\"/>"), std::string::npos);
    EXPECT_NE(xml.find("<property name=\"driver\" value=\"llvmpipe\"/>"), std::string::npos);
    std::vector<ReportEntry> odd;
    for (const std::string& name : test::oddNames()) odd.push_back(plainEntry(name, Status::Missing));
    const std::string escaped = junitOf(test::oddNames()[0], odd);
    EXPECT_EQ(test::markupProblem(escaped, false), "");
    EXPECT_EQ(test::countOf(escaped, "<testcase "), odd.size());
}

TEST(Annotations, AreALineForEachFailure)
{
    ReportEntry allowed = plainEntry("allowed", Status::New);
    allowed.allowed = true;
    ReportEntry different = plainEntry("a, b: 5 %.png", Status::Different);
    different.referencePath = "golden/a, b: 5 %.png";
    different.outputPath = "out/a, b: 5 %.png";
    different.line = "different: 5 %, or so\r\nindeed";
    ReportEntry added = plainEntry("new", Status::New);
    added.outputPath = "out/new";
    EXPECT_EQ(githubAnnotations({different, added, allowed, plainEntry("same", Status::Equal)}),
              "::error file=golden/a%2C b%3A 5 %25.png,title=a%2C b%3A 5 %25.png::"
              "different: 5 %25, or so%0D%0Aindeed\n"
              "::error file=out/new,title=new::line of new\n");
    std::vector<ReportEntry> odd;
    for (const std::string& name : test::oddNames()) odd.push_back(plainEntry(name, Status::Missing));
    EXPECT_EQ(test::countOf(githubAnnotations(odd), "\n"), odd.size());
}

}  // namespace
}  // namespace knuckle
