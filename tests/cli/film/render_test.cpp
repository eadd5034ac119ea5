#include <algorithm>
#include <cstring>
#include <filesystem>
#include <sstream>

#include "app/json/json.h"
#include "render/picture/image.h"
#include "tests/cli/cli_fixture.h"
#include "tests/places.h"

namespace knuckle {
namespace {

using test::RunResult;
using Render = test::CliTest;

TEST_F(Render, WritesFramesToAFolderOfTheScenesName)
{
    const RunResult result = run({"render", "tiny.json"});
    ASSERT_EQ(result.code, 0) << result.err;
    EXPECT_EQ(madeFiles(),
              (std::vector<std::string>{"out", "out/tiny", "out/tiny/frame_0001.png", "out/tiny/frame_0002.png",
                                        "out/tiny/frame_0003.png", "out/tiny/frame_0004.png"}));
    const Image frame = readImage(folder.path("out/tiny/frame_0004.png"));
    EXPECT_EQ(frame.width, 64u);
    EXPECT_EQ(frame.height, 36u);
}

TEST_F(Render, DrawsTheSameFramesWithAndWithoutThoseBefore)
{
    ASSERT_EQ(run({"render", scene, "-o", "all"}).code, 0);
    const RunResult part = run({"render", scene, "-o", "part", "--frames", "3:3"});
    ASSERT_EQ(part.code, 0) << part.err;
    EXPECT_EQ(test::listFolder(folder.path("part")), std::vector<std::string>{"frame_0003.png"});
    EXPECT_EQ(test::readText(folder.path("part/frame_0003.png")), test::readText(folder.path("all/frame_0003.png")));
}

TEST_F(Render, GivesTheSameStateAtAnyNumberOfDriverThreads)
{
    std::string first;
    for (const char* threads : {"LP_NUM_THREADS=0", "LP_NUM_THREADS=1", "LP_NUM_THREADS=2"}) {
        const RunResult result = run({"render", scene, "-o", "out", "--hash", "--quiet"}, {.environment = {threads}});
        ASSERT_EQ(result.code, 0) << result.err;
        EXPECT_TRUE(result.out.starts_with("state hash ") && result.out.size() == 28) << result.out;
        const std::string state = result.out + test::readText(folder.path("out/frame_0004.png"));
        if (first.empty()) first = state;
        EXPECT_TRUE(state == first) << threads;
    }
}

TEST_F(Render, TakesSizeRateAndFieldsFromTheCommandLine)
{
    const RunResult result = run({"render", scene, "-o", "out", "--size", "32x16", "--fps", "30", "--set",
                                  "duration=0.1", "--set", "render.colorBy=speed"});
    ASSERT_EQ(result.code, 0) << result.err;
    EXPECT_EQ(test::listFolder(folder.path("out")).size(), 3u);
    EXPECT_EQ(readImage(folder.path("out/frame_0001.png")).width, 32u);
    EXPECT_EQ(run({"render", scene, "--frames", "2:9"}).err,
              "knuckle: --frames 2:9: the scene has frames 1 to 4; choose among them or raise /duration\n");
}

TEST_F(Render, ChoosesTheDriversThreadsUnlessTheUserDoes)
{
    const auto threadsWith = [&](const char* variable) {
        const RunResult result = run({"render", scene, "-o", "out", "--quiet", "--stats", "stats.json"},
                                     {.environment = {variable}});
        EXPECT_EQ(result.code, 0) << result.err;
        return parseJson(test::readText(folder.path("stats.json")), "stats")["driverThreads"];
    };
    const Json set = threadsWith("LP_NUM_THREADS=3");
    EXPECT_TRUE(set["count"].is_null());
    EXPECT_EQ(set["reason"], "LP_NUM_THREADS is set to 3");
    // 55 particles on 64 x 36 pixels are a few microseconds of work. On a GPU nothing is chosen.
    const Json chosen = threadsWith("LP_NUM_THREADS=");
    EXPECT_TRUE(chosen["count"].is_null() || chosen["count"] == 0) << chosen;
    EXPECT_FALSE(chosen["reason"].get<std::string>().empty());
}

TEST_F(Render, SaysNothingWhenQuiet)
{
    const RunResult result = run({"--quiet", "render", scene});
    EXPECT_EQ(result.code, 0);
    EXPECT_EQ(result.out + result.err, "");
}

TEST_F(Render, WritesFigures)
{
    const RunResult result = run({"render", scene, "-o", "out", "--stats", "made/stats.json", "--hash"});
    ASSERT_EQ(result.code, 0) << result.err;
    const Json stats = parseJson(test::readText(folder.path("made/stats.json")), "stats");
    EXPECT_EQ(stats["particles"], 55);
    EXPECT_EQ(stats["frames"], 4);
    EXPECT_EQ(stats["steps"], 3);
    EXPECT_GE(stats["searches"], 1);
    EXPECT_LE(stats["searches"], 3 * stats["substeps"].get<int>());
    EXPECT_GT(stats["passes"].size(), 3u);
    EXPECT_GT(stats["drawingPasses"].size(), 3u);
    EXPECT_EQ(stats["drawingPasses"][0]["count"], 4);
    EXPECT_GT(stats["simulationSeconds"].get<double>(), 0.0);
    for (const char* part : {"deviceSeconds", "worldSeconds", "kernelSeconds", "firstPictureSeconds"})
        EXPECT_GT(stats["start"][part].get<double>(), 0.0) << part;
    for (const char* key : {"device", "contacts", "substeps", "worstPenetration", "worstJointGap", "releases"}) {
        EXPECT_TRUE(stats.contains(key)) << key;
    }
    EXPECT_NE(result.out.find("state hash " + stats["stateHash"].get<std::string>()), std::string::npos);
}

TEST_F(Render, WritesNoFigureThatIsNotDescribed)
{
    ASSERT_EQ(run({"render", scene, "-o", "out", "--stats", "stats.json"}).code, 0);
    const std::string described = test::readText(test::inSource("docs/output.md"));
    const Json stats = parseJson(test::readText(folder.path("stats.json")), "stats");
    for (const auto& [key, value] : stats.items()) {
        EXPECT_NE(described.find('`' + key + '`'), std::string::npos) << key;
    }
}

TEST_F(Render, TellsWhatWasLetGo)
{
    const std::string doll = folder.write(
        "doll.json", R"({ "duration": 0.5, "diameter": 0.05, "render": { "width": 64, "height": 36 },
        "objects": [{ "type": "actor", "name": "doll", "file": ")" +
                         test::inSource("assets/models/humanoid.glb") + R"(", "animation": { "clip": "dance" },
                      "release": [{ "time": 0.2, "below": "thigh.L" },
                                  { "region": { "shape": "box", "size": [1, 1, 1], "position": [0, 2, 0] } }] },
                    { "type": "actor", "name": "limp", "file": ")" +
                         test::inSource("assets/models/humanoid.glb") + R"(", "position": [3, 0, 0],
                      "pose": { "clip": "dance" } }] })");
    const RunResult result = run({"render", doll, "-o", "out", "--frames", "30:30", "--stats", "stats.json", "--hash"});
    ASSERT_EQ(result.code, 0) << result.err;
    const Json stats = parseJson(test::readText(folder.path("stats.json")), "stats");
    const Json& releases = stats["releases"];
    ASSERT_EQ(releases.size(), 1u) << releases;
    EXPECT_EQ(releases[0]["object"], "doll");
    EXPECT_GT(releases[0]["bodies"], 12) << "its head is in the region from the start";
    EXPECT_LT(releases[0]["time"].get<double>(), 0.01);
    EXPECT_LT(releases[0]["momentumChange"].get<double>(), 0.01);
    EXPECT_LT(releases[0]["worstBodyChange"].get<double>(), 0.02);
    EXPECT_LT(releases[0]["worstGap"].get<double>(), 0.05);
    // Printing statistics changes nothing.
    EXPECT_EQ(run({"render", doll, "-o", "out", "--frames", "30:30", "--hash", "-q"}).out,
              "state hash " + stats["stateHash"].get<std::string>() + "\n");
}

TEST_F(Render, ExportsParticles)
{
    ASSERT_EQ(run({"render", scene, "-o", "out", "--export", "ply=ply", "--frames", "1:2"}).code, 0);
    const std::string ply = test::readText(folder.path("ply/frame_0001.ply"));
    EXPECT_EQ(test::listFolder(folder.path("ply")).size(), 2u);
    EXPECT_TRUE(ply.starts_with("ply\nformat binary_little_endian 1.0\n"));
    EXPECT_NE(ply.find("\ncomment material 0 default\ncomment material 1 water\nelement vertex 55\n"),
              std::string::npos);
    const size_t start = ply.find("end_header\n") + 11;
    constexpr size_t ROW = 9 * 4;  // id, position, velocity, body, material
    ASSERT_EQ(ply.size() - start, 55 * ROW);
    float y = 0.0f;
    int32_t body = -1;
    std::memcpy(&y, ply.data() + start + 2 * 4, 4);
    std::memcpy(&body, ply.data() + start + 7 * 4, 4);
    EXPECT_NEAR(y, 0.2f, 1e-5f);  // the lowest layer of a cube of three layers whose middle is at 0.3 m
    EXPECT_EQ(body, 0);
}

TEST_F(Render, ExportsBodies)
{
    ASSERT_EQ(run({"render", scene, "-o", "out", "--export", "bodies=bodies.csv"}).code, 0);
    std::istringstream table(test::readText(folder.path("bodies.csv")));
    std::string line;
    std::getline(table, line);
    EXPECT_EQ(line, "frame,body,object,name,x,y,z,qx,qy,qz,qw,vx,vy,vz,wx,wy,wz");
    std::getline(table, line);
    EXPECT_TRUE(line.starts_with("1,0,pair,body_1,-0.19")) << line;
    size_t rows = 1;
    while (std::getline(table, line)) ++rows;
    EXPECT_EQ(rows, 4u * 2u);
}

TEST_F(Render, ExportsAsOftenAsItIsAskedTo)
{
    ASSERT_EQ(run({"render", scene, "-o", "out", "--export", "bodies=one.csv", "--export", "ply=ply", "--export",
                   "bodies=two.csv", "--export", "measures=m.csv"})
                  .code,
              0);
    const std::string one = test::readText(folder.path("one.csv"));
    EXPECT_EQ(std::ranges::count(one, '\n'), 1 + 4 * 2);
    EXPECT_EQ(test::readText(folder.path("two.csv")), one);
    EXPECT_TRUE(std::filesystem::exists(folder.path("ply/frame_0004.ply")));
    EXPECT_EQ(std::ranges::count(test::readText(folder.path("m.csv")), '\n'), 1 + 4);
}

TEST_F(Render, ExportsMeasuresOfEachFrameAsStatsOfTheLast)
{
    ASSERT_EQ(run({"render", scene, "-o", "out", "--export", "measures=m.csv", "--stats", "stats.json"}).code, 0);
    std::istringstream table(test::readText(folder.path("m.csv")));
    std::string head, line, last;
    std::getline(table, head);
    int rows = 0;
    for (; std::getline(table, line); ++rows) last = line;
    EXPECT_EQ(rows, 4);
    const Json stats = parseJson(test::readText(folder.path("stats.json")), "stats");
    std::istringstream names(head), values(last);
    std::string name, value;
    int columns = 0;
    while (std::getline(names, name, ',') && std::getline(values, value, ',')) {
        if (++columns > 1) EXPECT_EQ(parseJson(value, "value"), stats.at(name)) << name;
        else EXPECT_EQ(value, "4");
    }
    EXPECT_EQ(columns, 26);
}

TEST_F(Render, FallsWithAnActorThatWasVoxelizedBefore)
{
    const RunResult made = run({"voxelize", test::inSource("assets/models/humanoid.glb"), "-o", "actor.json",
                                "--diameter", "0.08", "--preview", "actor.png"});
    ASSERT_EQ(made.code, 0) << made.err;
    EXPECT_NE(made.out.find("shin.L"), std::string::npos) << made.out;
    EXPECT_EQ(readImage(folder.path("actor.png")).width, 1280u);
    folder.write("doll.json", R"({ "diameter": 0.08, "duration": 0.05, "colliders": [{ "type": "plane" }],
        "objects": [{ "type": "actor", "file": "actor.json" }], "render": { "width": 64, "height": 36 } })");
    const RunResult filmed = run({"render", "doll.json"});
    EXPECT_EQ(filmed.code, 0) << filmed.err;
    EXPECT_TRUE(std::filesystem::exists(folder.path("out/doll/frame_0003.png")));
}

TEST_F(Render, WarnsOfAnActorWithoutItsMesh)
{
    std::filesystem::copy_file(test::inSource("assets/models/humanoid.glb"), folder.path("figure.glb"));
    ASSERT_EQ(run({"voxelize", "figure.glb", "-o", "actor.json", "--diameter", "0.1"}).code, 0);
    std::filesystem::remove(folder.path("figure.glb"));
    folder.write("doll.json", R"({ "diameter": 0.1, "duration": 0.02, "render": { "width": 64, "height": 36 },
        "objects": [{ "type": "actor", "file": "actor.json" }] })");
    const RunResult filmed = run({"render", "doll.json", "--frames", "1:1"});
    EXPECT_EQ(filmed.code, 0);
    const std::string warning = "knuckle: warning: doll.json: /objects/0: its particles are drawn: actor.json was made "
                                "of figure.glb, which is not there; put it there\n";
    EXPECT_NE(filmed.err.find(warning), std::string::npos) << filmed.err;
    EXPECT_EQ(run({"render", "doll.json", "--frames", "1:1", "-q"}).err, "");
    EXPECT_NE(run({"check", "doll.json"}).out.find("doll.json: warning: /objects/0: "), std::string::npos);
}

TEST_F(Render, FilmsAndWritesFramesInOneRun)
{
    const RunResult result = run({"render", scene, "-o", "out", "-o", "film.mp4"});
    ASSERT_EQ(result.code, 0) << result.err;
    EXPECT_GT(std::filesystem::file_size(folder.path("film.mp4")), 500u);
    EXPECT_EQ(test::readText(folder.path("film.mp4")).substr(4, 4), "ftyp");
    EXPECT_EQ(test::listFolder(folder.path("out")).size(), 4u);
    EXPECT_EQ(madeFiles().size(), 6u);
}

}  // namespace
}  // namespace knuckle
