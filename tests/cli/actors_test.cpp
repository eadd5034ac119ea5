#include "app/json/json.h"
#include "render/picture/image.h"
#include "tests/cli/cli_fixture.h"
#include "tests/places.h"

namespace knuckle {
namespace {

using test::RunResult;

/// With two models, of boxes, and a file that is none.
class Actors : public test::CliTest {
protected:
    Actors()
    {
        std::filesystem::create_directories(folder.path("models/more"));
        folder.write("models/cube.obj", box("1"));
        folder.write("models/more/slab.obj", box("0.5"));
        folder.write("models/broken.obj", "nothing\n");
        folder.write("models/notes.md", "# Notes\n");
    }
    static std::string box(const std::string& height)
    {
        std::string text;
        for (const char* x : {"0", "1"})
            for (const std::string& y : {std::string("0"), height})
                for (const char* z : {"0", "1"}) text += std::string("v ") + x + " " + y + " " + z + "\n";
        return text + "f 1 2 4 3\nf 5 7 8 6\nf 1 5 6 2\nf 3 4 8 7\nf 1 3 7 5\nf 2 6 8 4\n";
    }
    /// The words of each line of a table.
    static std::vector<std::vector<std::string>> wordsOf(const std::string& table)
    {
        std::vector<std::vector<std::string>> rows;
        std::istringstream lines(table);
        for (std::string line; std::getline(lines, line);) {
            std::istringstream words(line);
            rows.emplace_back();
            for (std::string word; words >> word;) rows.back().push_back(word);
        }
        return rows;
    }
};

TEST_F(Actors, AreMadeOfSeveralModelsAndOfThoseInFolders)
{
    const RunResult result = run({"voxelize", "models", "models/cube.obj", "--diameter", "0.25", "-o", "out/"});
    EXPECT_EQ(result.code, 2);
    EXPECT_TRUE(result.err.starts_with("knuckle: models/broken.obj: ")) << result.err;
    EXPECT_TRUE(test::isOneLine(result.err)) << result.err;
    const auto rows = wordsOf(result.out);
    ASSERT_EQ(rows.size(), 4u) << result.out;
    EXPECT_EQ(rows[0], (std::vector<std::string>{"model", "particles", "diameter,", "m", "bodies", "joints"}));
    ASSERT_GT(rows[1].size(), 2u);
    EXPECT_EQ(rows[1][0], "models/broken.obj");
    EXPECT_EQ(rows[1][1], "failed:");
    EXPECT_EQ(rows[2], (std::vector<std::string>{"models/cube.obj", "41", "0.25", "1", "0"}));
    EXPECT_EQ(rows[3], (std::vector<std::string>{"models/more/slab.obj", "12", "0.25", "1", "0"}));
    EXPECT_EQ(test::listFolder(folder.path("out")), (std::vector<std::string>{"cube.actor.json", "slab.actor.json"}));
    // 41 * 1000 kg/m3 * (0.25 m)^3
    const RunResult check = run({"check", "out/cube.actor.json", "out/slab.actor.json", "tiny.json"});
    EXPECT_EQ(check.code, 0) << check.err;
    EXPECT_TRUE(check.out.starts_with("out/cube.actor.json: 41 particles, 1 body, 0 joints, particles of 0.25 m, "
                                      "640.6 kg at 1000 kg/m3\nout/slab.actor.json: 12 particles, "))
        << check.out;
    EXPECT_NE(check.out.find("\ntiny.json: "), std::string::npos);
}

TEST_F(Actors, OfSeveralModelsArePreviewedIntoAFolder)
{
    const RunResult result = run(
        {"-q", "voxelize", "models/cube.obj", "models/more", "--diameter", "0.25", "--preview", "pictures"});
    EXPECT_EQ(result.code, 0) << result.err;
    EXPECT_EQ(result.out + result.err, "");
    EXPECT_EQ(test::listFolder(folder.path("pictures")), (std::vector<std::string>{"cube.png", "slab.png"}));
    EXPECT_EQ(readImage(folder.path("pictures/slab.png")).width, 1280u);
}

TEST_F(Actors, OfSeveralModelsAreNotWrittenOverEachOther)
{
    folder.write("cube.obj", box("2"));
    const RunResult result = run({"voxelize", "cube.obj", "models/cube.obj", "--diameter", "0.25", "-o", "out"});
    EXPECT_EQ(result.code, 2);
    EXPECT_EQ(result.err, "knuckle: models/cube.obj: has the name of cube.obj; rename one, or voxelize it alone\n");
    EXPECT_GT(parseJson(test::readText(folder.path("out/cube.actor.json")), "actor")["particles"].size(), 41u);
    EXPECT_EQ(run({"voxelize", "cube.obj", "models/cube.obj", "--diameter", "0.25"}).code, 0) << "nothing is written";
    const std::vector<std::string> several{"voxelize", "cube.obj", "models/more/slab.obj"};
    const auto refused = [&](std::vector<std::string> more, const std::string& message) {
        more.insert(more.begin(), several.begin(), several.end());
        expectError(run(more), 2, message);
    };
    refused({"-o", "all.json"}, "-o all.json: several models are written into a folder; name one, or all.json/");
    refused({"-o", "-"}, "-o standard output: several models are written into a folder; name one");
    refused({"--preview", "a.png"}, "--preview a.png: several models are written into a folder; name one, or a.png/");
    std::filesystem::create_directory(folder.path("empty"));
    const RunResult empty = run({"voxelize", "empty"});
    EXPECT_EQ(empty.code, 2);
    EXPECT_TRUE(empty.err.starts_with("knuckle: empty: no model is in this folder; one ends in .glb ")) << empty.err;
}

TEST_F(Actors, ThatAreWrongAreToldByCheckEachInALine)
{
    ASSERT_EQ(run({"-q", "voxelize", "models/cube.obj", "--diameter", "0.25", "-o", "cube.json"}).code, 0);
    std::string text = test::readText(folder.path("cube.json"));
    text.replace(text.find("\"particles\": [0, 1"), 18, "\"particles\": [1");
    folder.write("wrong.json", text);
    const RunResult result = run({"check", "wrong.json", "cube.json", "tiny.json"});
    EXPECT_EQ(result.code, 2);
    EXPECT_EQ(result.err, "knuckle: wrong.json: /particles/0: belongs to no body; remove it\n");
    EXPECT_TRUE(result.out.starts_with("cube.json: 41 particles, ")) << result.out;
    EXPECT_EQ(run({"check", "-q", "cube.json"}).out, "");
    expectError(run({"check", "cube.json", "--set", "diameter=1"}), 2,
                "cube.json: --set changes fields of scenes, and this is an actor; check it alone");
}

TEST_F(Actors, OfTheProjectsOwnModelsAreFine)
{
    const RunResult made = run({"-q", "voxelize", test::inSource("assets/models"), "-o", "out"});
    ASSERT_EQ(made.code, 0) << made.err;
    std::vector<std::string> words{"check"};
    for (const std::string& file : test::listFolder(folder.path("out"))) words.push_back("out/" + file);
    EXPECT_GE(words.size(), 4u);
    const RunResult check = run(words);
    EXPECT_EQ(check.err, "");
    EXPECT_EQ(check.out.find("warning"), std::string::npos) << check.out;
}

TEST_F(Actors, OfSeveralLevelsAreAFileEachWithTheSameBodies)
{
    const std::string figure = test::inSource("assets/models/humanoid.glb");
    const RunResult result = run({"voxelize", figure, "--levels", "300,100", "-o", "figure.actor.json"});
    ASSERT_EQ(result.code, 0) << result.err;
    const auto rows = wordsOf(result.out.substr(result.out.find("\nmodel ") + 1));
    ASSERT_EQ(rows.size(), 3u) << result.out;
    EXPECT_EQ(rows[1][1], "100");
    EXPECT_EQ(rows[2][1], "300");
    EXPECT_EQ(rows[1][4], rows[2][4]);
    const auto bodiesIn = [&](const std::string& file) {
        std::vector<std::string> names;
        const JsonFile actor = readJsonFile(folder.path(file));
        for (const Json& body : actor.root["bodies"]) names.push_back(body["name"]);
        return names;
    };
    EXPECT_EQ(bodiesIn("figure-100.actor.json"), bodiesIn("figure-300.actor.json"));
    const RunResult alone = run({"-q", "voxelize", figure, "--particles", "300", "-o", "alone.json"});
    EXPECT_GT(bodiesIn("alone.json").size(), bodiesIn("figure-300.actor.json").size());
    expectError(run({"voxelize", figure, "--levels", "300,1000", "-o", "-"}), 2,
                "-o -: levels are a file each; name one, as in -o actor.json");
}

TEST_F(Actors, OfSeveralModelsAreTheSameWithMoreJobs)
{
    for (const char* jobs : {"1", "3"}) {
        const std::string out = std::string("out") + jobs;
        EXPECT_EQ(run({"voxelize", "models", "--levels", "50,200", "-o", out, "--jobs", jobs}).code, 2);
    }
    EXPECT_EQ(test::listFolder(folder.path("out1")),
              (std::vector<std::string>{"cube-200.actor.json", "cube-50.actor.json", "slab-200.actor.json",
                                        "slab-50.actor.json"}));
    for (const std::string& file : test::listFolder(folder.path("out1")))
        EXPECT_EQ(test::readText(folder.path("out1/" + file)), test::readText(folder.path("out3/" + file))) << file;
}

TEST_F(Actors, AreArraysWhereTheNameSaysSo)
{
    EXPECT_EQ(run({"-q", "voxelize", "models/cube.obj", "--diameter", "0.25", "-o", "cube.npz"}).code, 0);
    const RunResult check = run({"check", "cube.npz"});
    EXPECT_EQ(check.out, "cube.npz: 41 particles, 1 body, 0 joints, particles of 0.25 m, 640.6 kg at 1000 kg/m3\n");
    folder.write("scene.json", R"({ "objects": [{ "type": "actor", "file": "cube.npz" }] })");
    EXPECT_EQ(run({"check", "scene.json"}).code, 0);
    folder.write("text.npz", "{}");
    expectError(run({"check", "text.npz"}), 2, "text.npz: is no zip archive, or ends early; save it again");
}

}  // namespace
}  // namespace knuckle
