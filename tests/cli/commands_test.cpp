#include <unistd.h>

#include <csignal>

#include "app/json/json.h"
#include "render/picture/image.h"
#include "tests/cli/cli_fixture.h"

namespace knuckle {
namespace {

using test::RunResult;
using Cli = test::CliTest;

TEST_F(Cli, TellsItsVersionAndHelp)
{
    const RunResult version = run({"--version"});
    EXPECT_EQ(version.code, 0);
    EXPECT_TRUE(version.out.starts_with("knuckle 0.")) << version.out;
    for (const char* command :
         {"", "render", "voxelize", "check", "compare", "info", "schema", "doctor", "completion", "man"}) {
        const RunResult help = run(*command ? std::vector<std::string>{command, "--help"}
                                            : std::vector<std::string>{"--help"});
        EXPECT_EQ(help.code, 0);
        EXPECT_NE(help.out.find("Usage:"), std::string::npos) << command;
        EXPECT_EQ(help.err, "");
    }
}

TEST_F(Cli, RefusesWrongOptionsInOneLine)
{
    for (const std::vector<std::string>& words :
         std::vector<std::vector<std::string>>{{},
                                               {"rendr"},
                                               {"render"},
                                               {"render", scene, "--nonsense"},
                                               {"render", scene, "--fps", "fast"},
                                               {"render", scene, "--fps", "1"},
                                               {"compare", "a.png"},
                                               {"schema", "nothing"},
                                               {"voxelize", "a.glb", "--diameter", "-1"},
                                               {"voxelize", "a.glb", "--up", "x"},
                                               {"voxelize", "a.glb", "--height", "2", "--scale", "1"},
                                               {"render", scene, "--size", "64"},
                                               {"render", scene, "--size", "0x0"},
                                               {"render", scene, "--frames", "0:3"},
                                               {"render", scene, "--frames", "3:2"},
                                               {"render", scene, "--frames", "x"},
                                               {"render", scene, "--export", "obj=x"},
                                               {"render", scene, "--export", "ply="},
                                               {"render", scene, "--set", "fps"},
                                               {"render", scene, "-o", "film.avi"},
                                               {"bench", "table2", "--preset", "papr"},
                                               {"bench", "table2", "--set", "duration=3"},
                                               {"bench", "table2", "--set", "solver.iterations=0"}}) {
        const RunResult result = run(words);
        EXPECT_EQ(result.code, 2) << (words.empty() ? "" : words.back());
        EXPECT_TRUE(test::isOneLine(result.err)) << result.err;
        EXPECT_EQ(result.out, "");
    }
    EXPECT_TRUE(madeFiles().empty());
}

TEST_F(Cli, RefusesDevicesThatAreNotThere)
{
    const RunResult word = test::runKnuckle({"info", "--device", "quantum"});
    EXPECT_EQ(word.code, 2);
    EXPECT_TRUE(test::isOneLine(word.err)) << word.err;
    const RunResult number = test::runKnuckle({"render", scene, "--device", "99"}, {.folder = folder.path()});
    EXPECT_EQ(number.code, 2) << number.err;
    EXPECT_TRUE(test::isOneLine(number.err)) << number.err;
}

TEST_F(Cli, ListsDevicesAndLimits)
{
    const RunResult result = run({"info"});
    EXPECT_EQ(result.code, 0) << result.err;
    EXPECT_NE(result.out.find("software"), std::string::npos);
    EXPECT_NE(result.out.find("largest storage buffer"), std::string::npos);
}

TEST_F(Cli, ChecksEveryScene)
{
    const std::string bad = folder.write("bad.json", R"({ "objects": [], "fps": 60 })");
    const RunResult result = run({"check", bad, scene});
    EXPECT_EQ(result.code, 2);
    EXPECT_EQ(result.out, scene + ": 55 particles, 2 bodies, 1 joint, 1 collider, 0.0667 s (4 frames)\n");
    EXPECT_EQ(result.err, "knuckle: " + bad + ": /objects: is an array of 0, must be at least 1\n");
    EXPECT_EQ(run({"check", scene}).code, 0);
    EXPECT_EQ(run({"check", scene, "--quiet"}).out, "");
}

TEST_F(Cli, PrintsItsSchemas)
{
    for (const char* document : {"scene", "actor", "joints", "limits"}) {
        const RunResult result = run({"schema", document});
        EXPECT_EQ(result.code, 0);
        EXPECT_NO_THROW(parseJson(result.out, document));
    }
    EXPECT_TRUE(run({"schema", "--markdown"}).out.starts_with("# Scene files"));
}

TEST_F(Cli, TellsAFullStandardOutput)
{
    const RunResult result = run({"schema"}, {.standardOutput = "/dev/full"});
    EXPECT_EQ(result.code, 1);
    EXPECT_TRUE(test::isOneLine(result.err)) << result.err;
    EXPECT_NE(result.err.find("No space left"), std::string::npos) << result.err;
}

/// Replaces the descriptor by a pipe that nobody reads.
std::function<void()> closedPipe(int descriptor)
{
    return [descriptor] {
        int ends[2];
        if (pipe(ends) != 0) _exit(125);
        close(ends[0]);
        dup2(ends[1], descriptor);
    };
}

TEST_F(Cli, EndsAsFiltersDoWhenItsReaderGoesAway)
{
    for (const std::vector<std::string>& words :
         std::vector<std::vector<std::string>>{{"schema"}, {"--help"}, {"check", scene}}) {
        const RunResult result = run(words, {.inChild = closedPipe(STDOUT_FILENO)});
        EXPECT_EQ(result.code, 1000 + SIGPIPE) << words.front();
        EXPECT_EQ(result.err, "") << words.front();
    }
    EXPECT_EQ(run({"render", "none.json"}, {.inChild = closedPipe(STDERR_FILENO)}).code, 2);
}

}  // namespace
}  // namespace knuckle
