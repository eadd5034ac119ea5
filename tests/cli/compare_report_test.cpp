#include <filesystem>

#include "app/compare/compare_run.h"
#include "render/picture/image.h"
#include "tests/cli/cli_fixture.h"

namespace knuckle {
namespace {

namespace fs = std::filesystem;
using test::RunResult;

/// golden and out: same.png, changed.png that differs, gone.png, and new.png, and those of a test.
class CompareReport : public test::CliTest {
protected:
    CompareReport()
    {
        for (const char* place : {"golden", "out"}) fs::create_directories(folder.path(place));
        for (const char* name : {"golden/same.png", "out/same.png", "golden/changed.png", "golden/gone.png"})
            write(name, 0);
        write("out/changed.png", 12);
        write("out/new.png", 5);
    }
    /// A grey picture with a white box.
    void write(const std::string& name, uint32_t box) const
    {
        Image image{40, 30, std::vector<uint8_t>(size_t{3} * 40 * 30, 90)};
        for (uint32_t y = 0; y < box; ++y)
            for (uint32_t i = 0; i < box * 3; ++i) image.rgb[y * 120 + i] = 255;
        writePng(folder.path(name), image);
    }
    RunResult compare(std::vector<std::string> options, const std::string& a = "golden",
                      const std::string& b = "out") const
    {
        options.insert(options.begin(), {"compare", a, b});
        return run(options);
    }
    size_t picturesIn(const std::string& file) const
    {
        const std::string page = test::readText(folder.path(file));
        size_t count = 0;
        for (size_t i = page.find("<img class="); i != std::string::npos; i = page.find("<img class=", i + 1)) ++count;
        return count;
    }
    std::string written(const std::string& file) const { return test::readText(folder.path(file)); }
};

TEST_F(CompareReport, ShowsWhatDiffersOfFolders)
{
    const RunResult plain = compare({}), result = compare({"--report", "pages/r.html", "--junit", "r.xml"});
    EXPECT_EQ(result.code, 4);
    EXPECT_EQ(result.out, plain.out) << "what is printed stays the same";
    EXPECT_EQ(result.err, "");
    EXPECT_EQ(picturesIn("pages/r.html"), 4u + 1u + 1u) << "changed, gone and new";
    EXPECT_NE(written("pages/r.html").find("<p class=\"summary failed\">1 of 2 images differs, 1 missing, 1 new</p>"),
              std::string::npos);
    EXPECT_EQ(test::listFolder(folder.path("pages")), std::vector<std::string>{"r.html"});
    EXPECT_NE(written("r.xml").find("<testsuites tests=\"4\" failures=\"3\" errors=\"0\">"), std::string::npos);
    EXPECT_EQ(compare({"--report", "again.html", "--quiet"}).out, "");
    EXPECT_EQ(written("again.html"), written("pages/r.html")) << "the same bits";
    EXPECT_EQ(compare({"--report", "all.html", "--report-all", "--allow-new"}).code, 4);
    EXPECT_EQ(picturesIn("all.html"), 4u + 1u + 1u + 4u);
    EXPECT_EQ(compare({"--report", "out/r.html"}).code, 4) << "no image, so that it may lie there";
    EXPECT_EQ(compare({"--report", "out/r.html"}).code, 4) << "again";
}

TEST_F(CompareReport, ShowsTwoImages)
{
    const RunResult result = compare({"--report", "r.html", "--junit", "r.xml"}, "golden/changed.png",
                                     "out/changed.png");
    EXPECT_EQ(result.code, 4);
    EXPECT_EQ(picturesIn("r.html"), 4u);
    EXPECT_NE(written("r.xml").find("name=\"changed.png\""), std::string::npos);
    EXPECT_EQ(compare({"--report", "r.html"}, "golden/same.png", "out/same.png").code, 0);
    EXPECT_EQ(picturesIn("r.html"), 0u);
    EXPECT_NE(written("r.html").find("<p class=\"summary passed\">0 of 1 images differ</p>"), std::string::npos);
    folder.write("out/changed.png", "broken");
    const RunResult broken = compare({"--report", "r.html", "--junit", "r.xml"}, "golden/changed.png",
                                     "out/changed.png");
    expectError(broken, 2,
                "image out/changed.png cannot be read: it is none of PNG, JPEG and EXR; convert it to one of them");
    EXPECT_EQ(picturesIn("r.html"), 1u) << "the one that can be read";
    EXPECT_NE(written("r.xml").find("<error type=\"unreadable\" message=\"image out/changed.png cannot be read"),
              std::string::npos);
}

TEST_F(CompareReport, GoesOnAfterWhatCannotBeRead)
{
    folder.write("out/same.png", "broken");
    folder.write("golden/gone.png", "");
    const RunResult result = compare({"--report", "r.html", "--junit", "r.xml"});
    EXPECT_EQ(result.code, 2);
    EXPECT_EQ(result.err, "knuckle: image out/same.png cannot be read: it is none of PNG, JPEG and EXR; convert it to "
                          "one of them\n");
    EXPECT_EQ(picturesIn("r.html"), 4u + 1u + 1u) << "changed, the golden one of same, and new";
    EXPECT_NE(written("r.html").find("image golden/gone.png cannot be read: it is empty"), std::string::npos);
    EXPECT_NE(written("r.xml").find("failures=\"3\" errors=\"1\""), std::string::npos);
}

TEST_F(CompareReport, LeavesOutPicturesThatAreTooMany)
{
    const RunResult result = compare({"--report", "r.html", "--report-size", "0"});
    EXPECT_EQ(result.code, 4);
    EXPECT_EQ(result.err, "r.html lacks pictures, of images that differ least: it would have more than 0 MB; see "
                          "--report-size\n");
    EXPECT_EQ(picturesIn("r.html"), 0u);
    EXPECT_NE(written("r.html").find("Pictures of the last 3 images that have any are left out"), std::string::npos);
}

TEST_F(CompareReport, KeepsNoFiguresOfSinglePixels)
{
    const ReportEntry entry = compareImageFiles({}, folder.path("golden/changed.png"), folder.path("out/changed.png"),
                                                "changed.png", 1);
    EXPECT_EQ(entry.status, ReportEntry::Status::Different);
    EXPECT_EQ(entry.comparison.differences.marks.capacity(), 0u) << "of thousands of images that is much";
    EXPECT_EQ(entry.comparison.flip.errors.capacity(), 0u);
    EXPECT_EQ(entry.pictures.bytes(), 0u);
}

TEST_F(CompareReport, AnnotatesForGithub)
{
    const RunResult result = compare({"--annotations", "github", "--quiet"});
    EXPECT_EQ(result.code, 4);
    EXPECT_TRUE(result.out.starts_with("::error file=golden/changed.png,title=changed.png::different: 144 of 1200 "
                                       "pixels differ by more than 8 of 255 (6 may, 0.5 %25); "))
        << result.out;
    EXPECT_TRUE(result.out.ends_with("\n::error file=golden/gone.png,title=gone.png::missing in out\n"
                                     "::error file=out/new.png,title=new.png::new, not in golden\n"))
        << result.out;
    EXPECT_EQ(compare({"--annotations", "github", "--quiet"}, "golden/same.png", "out/same.png").out, "");
}

TEST_F(CompareReport, RefusesOptionsThatDoNotFit)
{
    const std::string remedy = "; name it so, or - for standard output";
    expectError(compare({"--report", "r.png"}), 2, "--report r.png: a report is written as .html or .htm" + remedy);
    expectError(compare({"--junit", "r.html"}), 2, "--junit r.html: JUnit's XML is written as .xml" + remedy);
    const RunResult piped = compare({"--report", "-"});
    EXPECT_TRUE(piped.out.starts_with("<!DOCTYPE html>") && piped.out.ends_with("</html>\n")) << "the page alone";
    EXPECT_TRUE(piped.err.ends_with("1 of 2 images differs, 1 missing, 1 new\n")) << piped.err;
    for (const std::vector<std::string>& options : {std::vector<std::string>{"--report-all"}, {"--report-size", "5"}})
        expectError(compare(options), 2,
                    "--report-all and --report-size are for --report; name its file, or leave them out");
    expectError(compare({"--json", "--annotations", "github"}), 2,
                "--json and --annotations both print to standard output; leave one of them out");
    EXPECT_EQ(compare({"--annotations", "gitlab"}).code, 2);
    EXPECT_EQ(compare({"--report", "r.html", "--report-size", "-1"}).code, 2);
    EXPECT_EQ(compare({"--report", "/dev/null/r.html"}).code, 2);
    // A link under the right name to an image that is compared.
    fs::create_symlink("golden/same.png", folder.path("link.html"));
    const std::string before = written("golden/same.png");
    EXPECT_EQ(compare({"--report", "link.html"}).code, 2);
    EXPECT_EQ(compare({"--report", "link.html"}, "golden/same.png", "out/same.png").code, 2);
    EXPECT_EQ(written("golden/same.png"), before);
}

TEST_F(CompareReport, TakesAnyName)
{
    const std::string name = "<script>alert(1)<!--\"'&\n.png";
    for (const char* place : {"golden/", "out/"}) write(place + name, 0);
    write("out/" + name, 9);
    EXPECT_EQ(compare({"--report", "r.html", "--junit", "r.xml"}).code, 4);
    for (const char* file : {"r.html", "r.xml"}) {
        EXPECT_EQ(written(file).find("<script>alert"), std::string::npos);
        EXPECT_NE(written(file).find("&lt;script&gt;alert(1)&lt;!--&quot;&#39;&amp;&#10;.png"), std::string::npos);
    }
}

}  // namespace
}  // namespace knuckle
