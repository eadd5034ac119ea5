#include "app/json/json.h"
#include "tests/cli/cli_fixture.h"
#include "tests/places.h"

namespace knuckle {
namespace {

using test::RunResult;
using Bench = test::CliTest;

/// Two steps of one pair, one of them drawn.
const std::vector<std::string> SHORT = {"bench", "table2", "--objects", "1", "--steps", "2", "--drawn-steps", "1"};

std::vector<std::string> withJson()
{
    std::vector<std::string> words = SHORT;
    words.push_back("--json");
    return words;
}

void expectDescribed(const Json& object)
{
    const std::string page = test::readText(test::inSource("docs/output.md"));
    const std::string described = page.substr(page.find("## Speed"));
    for (const auto& [key, value] : object.items())
        EXPECT_NE(described.find('`' + key + '`'), std::string::npos) << key;
}

TEST_F(Bench, PrintsARowForEachRun)
{
    const RunResult result = run(SHORT);
    EXPECT_EQ(result.code, 0) << result.err;
    EXPECT_NE(result.out.find("\ndefault       1"), std::string::npos) << result.out;
}

TEST_F(Bench, WritesFiguresAsJson)
{
    const RunResult result = run(withJson());
    ASSERT_EQ(result.code, 0) << result.err;
    const Json figures = parseJson(result.out, "figures");
    EXPECT_EQ(figures["benchmark"], "table2");
    EXPECT_EQ(figures["steps"], 2);
    EXPECT_EQ(figures["settledSteps"], 2);
    EXPECT_EQ(figures["drawnSteps"], 1);
    ASSERT_EQ(figures["runs"].size(), 1u);
    const Json& first = figures["runs"][0];
    EXPECT_EQ(first["preset"], "default");
    EXPECT_EQ(first["objectCount"], 1);
    EXPECT_TRUE(first["published"].is_null());
    for (const char* key : {"stepsPerSecond", "settledStepsPerSecond", "drawnStepsPerSecond", "pileTop"}) {
        EXPECT_GT(first[key].get<double>(), 0.0) << key;
    }
}

/// Four steps of two actors, two of them animated.
const std::vector<std::string> TROUPE = {
    "bench", "troupe", "--objects", "2", "--steps", "4", "--model", test::inSource("assets/models/humanoid.glb")};

TEST_F(Bench, TimesATroupeBeforeAndAfterItIsLetGo)
{
    const RunResult table = run(TROUPE);
    EXPECT_EQ(table.code, 0) << table.err;
    EXPECT_NE(table.out.find("\ndefault      2       1286      36"), std::string::npos) << table.out;
    std::vector<std::string> words = TROUPE;
    words.push_back("--json");
    const Json first = parseJson(run(words).out, "figures")["runs"][0];
    for (const char* key : {"animatedMilliseconds", "limpMilliseconds", "settledMilliseconds", "pileTop"})
        EXPECT_GT(first[key].get<double>(), 0.0) << key;
    expectDescribed(first);
}

/// Three frames of two figures.
const std::vector<std::string> DRAW = {
    "bench", "draw", "--objects", "2", "--drawn-steps", "3", "--model", test::inSource("assets/models/humanoid.glb")};

TEST_F(Bench, TimesACrowdAsSpheresAndInItsSkins)
{
    const RunResult table = run(DRAW);
    EXPECT_EQ(table.code, 0) << table.err;
    EXPECT_NE(table.out.find("\n     2       3452      28582"), std::string::npos) << table.out;
    std::vector<std::string> words = DRAW;
    words.push_back("--json");
    const Json figures = parseJson(run(words).out, "figures");
    EXPECT_EQ(figures["drawnSteps"], 3);
    const Json& first = figures["runs"][0];
    for (const char* key : {"bareMilliseconds", "spheresMilliseconds", "skinsMilliseconds"})
        EXPECT_GT(first[key].get<double>(), 0.0) << key;
    expectDescribed(first);
}

TEST_F(Bench, TimesWaterAsSpheresAndAsASurface)
{
    const std::vector<std::string> water = {"bench", "water", "--objects", "1", "--drawn-steps", "3"};
    const RunResult table = run(water);
    EXPECT_EQ(table.code, 0) << table.err;
    EXPECT_NE(table.out.find("\n     1       4096"), std::string::npos) << table.out;
    std::vector<std::string> words = water;
    words.push_back("--json");
    const Json first = parseJson(run(words).out, "figures")["runs"][0];
    for (const char* key : {"bareMilliseconds", "spheresMilliseconds", "surfaceMilliseconds"})
        EXPECT_GT(first[key].get<double>(), 0.0) << key;
    expectDescribed(first);
}

TEST_F(Bench, TimesColumnsThatBreak)
{
    for (const char* benchmark : {"dam", "sand"}) {
        const std::vector<std::string> column = {"bench", benchmark, "--objects", "1", "--steps", "2"};
        const RunResult table = run(column);
        EXPECT_EQ(table.code, 0) << table.err;
        EXPECT_NE(table.out.find("\ndefault      1       4096"), std::string::npos) << table.out;
        std::vector<std::string> words = column;
        words.push_back("--json");
        const Json figures = parseJson(run(words).out, "figures");
        EXPECT_EQ(figures["benchmark"], benchmark);
        const Json& first = figures["runs"][0];
        for (const char* key : {"milliseconds", "settledMilliseconds", "microsecondsPerParticle", "substeps"})
            EXPECT_GT(first[key].get<double>(), 0.0) << key;
        EXPECT_NEAR(first["microsecondsPerParticle"].get<double>(), first["milliseconds"].get<double>() / 4.096, 1e-6);
        expectDescribed(first);
    }
}

TEST_F(Bench, ScalesWithTheNumberOfParticles)
{
    const std::vector<std::string> scale = {"bench",    "scale", "--particles", "1000,2000",
                                            "--settle", "1",     "--steps",     "1"};
    const RunResult table = run(scale);
    EXPECT_EQ(table.code, 0) << table.err;
    // One and four times eight pairs; 8 and 11 columns each way, 16 high.
    for (const char* row : {"\npairs        462", "\npairs       1848", "\ndam         1024", "\ndam         1936"})
        EXPECT_NE(table.out.find(row), std::string::npos) << row << table.out;
    std::vector<std::string> words = scale;
    words.insert(words.end(), {"--world", "dam", "--json"});
    const Json figures = parseJson(run(words).out, "figures");
    EXPECT_EQ(figures["benchmark"], "scale");
    ASSERT_EQ(figures["runs"].size(), 2u);
    const Json& last = figures["runs"][1];
    EXPECT_EQ(last["world"], "dam");
    EXPECT_TRUE(last["problem"].is_null());
    for (const char* key : {"milliseconds", "microsecondsPerParticle", "bufferBytes"})
        EXPECT_GT(last[key].get<double>(), 0.0) << key;
    EXPECT_DOUBLE_EQ(last["bytesPerParticle"].get<double>(), last["bufferBytes"].get<double>() / 1936.0);
    EXPECT_GT(last["passes"].size(), 10u);
    expectDescribed(last);
    EXPECT_EQ(run({"bench", "scale", "--particles", "99"}).code, 2);
    EXPECT_EQ(run({"bench", "scale", "--world", "lava"}).code, 2);
}

TEST_F(Bench, DrawingNeedsFrames)
{
    for (const char* benchmark : {"draw", "water"}) {
        const RunResult none = run({"bench", benchmark, "--drawn-steps", "0"});
        EXPECT_EQ(none.code, 2) << benchmark;
        EXPECT_NE(none.err.find("--drawn-steps"), std::string::npos) << none.err;
    }
}

TEST_F(Bench, ATroupeNeedsAModelThatWalks)
{
    const RunResult result = run({"bench", "troupe", "--model", "nowhere.glb"});
    EXPECT_EQ(result.code, 2);
    EXPECT_NE(result.err.find("nowhere.glb"), std::string::npos) << result.err;
}

TEST_F(Bench, WritesNoFigureThatIsNotDescribed)
{
    const Json figures = parseJson(run(withJson()).out, "figures");
    expectDescribed(figures);
    expectDescribed(figures["runs"][0]);
}

}  // namespace
}  // namespace knuckle
