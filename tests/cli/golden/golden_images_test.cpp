#include <filesystem>

#include "render/picture/image.h"
#include "tests/cli/golden/golden_fixture.h"

namespace knuckle::test {
namespace {

namespace fs = std::filesystem;

/// Pictures of another program.
class GoldenImages : public GoldenTest {
protected:
    static Image grey(uint8_t value) { return {24, 16, std::vector<uint8_t>(size_t{24} * 16 * 3, value)}; }
    void addImages(const std::string& command)
    {
        writePng(folder.path("bright.png"), grey(200));
        writePng(folder.path("dark.png"), grey(40));
        fs::create_directory(folder.path("out"));
        const RunResult result = run({"golden", "add", "out/logo.png", "--command", command});
        ASSERT_EQ(result.code, 0) << result.err;
    }
};

TEST_F(GoldenImages, AreMadeAnewByTheirCommand)
{
    addImages("cp bright.png out/logo.png");
    EXPECT_EQ(listFolder(folder.path("golden/logo")), (std::vector<std::string>{"golden.json", "logo.png"}));
    EXPECT_EQ(check().out, "1 golden: 0 of 1 pictures differ\n");
    writePng(folder.path("bright.png"), grey(203));
    const RunResult result = check();
    EXPECT_EQ(result.code, 4);
    EXPECT_TRUE(has(result, "logo/logo: image: different: ")) << result.out;
    EXPECT_EQ(run({"golden", "update"}).code, 0);
    EXPECT_EQ(check().code, 0);
}

TEST_F(GoldenImages, SayWhatTheirCommandDidNotDo)
{
    addImages("cp bright.png out/logo.png");
    edit("golden/logo/golden.json", "cp bright.png", "echo no paint left >&2; exit 3; cp dark.png");
    const RunResult failed = check();
    EXPECT_EQ(failed.code, 2);
    EXPECT_EQ(failed.err,
              "knuckle: logo: golden/logo/golden.json: /command: echo no paint left >&2; exit 3; cp dark.png "
              "out/logo.png failed with exit code 3; its last line: no paint left\n");
    edit("golden/logo/golden.json", "exit 3; cp dark.png out/logo.png", "true");
    const RunResult idle = check();
    EXPECT_EQ(idle.code, 2);
    EXPECT_NE(idle.err.find("did not write out/logo.png\n"), std::string::npos) << idle.err;
}

TEST_F(GoldenImages, DoNotWaitForWhatACommandLeavesRunning)
{
    addImages("sleep 30 & cp bright.png out/logo.png");
    EXPECT_EQ(check().code, 0);
}

TEST_F(GoldenImages, AreNotTheirOwnReferences)
{
    fs::create_directory(folder.path("golden"));
    fs::create_directory(folder.path("golden/own"));
    writePng(folder.path("golden/own/logo.png"), grey(9));
    const RunResult result = run({"golden", "add", "golden/own/logo.png", "--name", "own"});
    EXPECT_EQ(result.code, 2);
    EXPECT_NE(result.err.find("is its own reference; put the golden into another folder\n"), std::string::npos)
        << result.err;
}

}  // namespace
}  // namespace knuckle::test
