#include <filesystem>

#include "tests/cli/cli_fixture.h"

namespace knuckle {
namespace {

namespace fs = std::filesystem;
using test::RunResult;

/// Files to be read, under several names.
class Paths : public test::CliTest {
protected:
    static constexpr const char* BYTES = "not a model";

    Paths()
    {
        folder.write("model.json", BYTES);
        fs::create_directory(folder.path("sub"));
        fs::create_symlink("../model.json", folder.path("sub/link.json"));
        fs::create_hard_link(folder.path("model.json"), folder.path("hard.json"));
    }
    void expectRefused(const std::vector<std::string>& words, const std::string& why) const
    {
        const auto before = test::listFolder(folder.path());
        const RunResult result = run(words);
        EXPECT_EQ(result.code, 2) << words.back();
        EXPECT_TRUE(test::isOneLine(result.err)) << result.err;
        EXPECT_NE(result.err.find(why), std::string::npos) << result.err;
        EXPECT_EQ(test::listFolder(folder.path()), before);
        EXPECT_EQ(test::readText(folder.path("model.json")), BYTES);
    }
};

TEST_F(Paths, OfAnOutputAreNotThoseOfAnInput)
{
    const std::string read = "which is read; give the output another name";
    for (const std::string& path :
         {std::string("model.json"), std::string("./model.json"), std::string("sub/../model.json"),
          std::string("sub/link.json"), std::string("hard.json"), folder.path("model.json")}) {
        expectRefused({"voxelize", "model.json", "-o", path}, path + " would be written over model.json, " + read);
        expectRefused({"voxelize", "none.obj", "--joints", "model.json", "-o", path}, read);
    }
    fs::rename(folder.path("hard.json"), folder.path("hard.png"));
    expectRefused({"compare", "model.json", "none.png", "--difference", "hard.png"}, read);
    expectRefused({"compare", "none.png", "model.json", "--difference", "./sub/../hard.png"}, read);
    expectRefused({"render", scene, "-o", "out", "--stats", "./tiny.json"}, read);
}

TEST_F(Paths, OfFilesThatAModelNamesAreInputsToo)
{
    folder.write("parts.gltf", R"({ "asset": { "version": "2.0" }, "images": [{ "uri": "skin%20a.png" }],
                                    "buffers": [{ "uri": "hard.json", "byteLength": 4 }] })");
    expectRefused({"voxelize", "parts.gltf", "-o", "model.json"}, "hard.json, which is read");
    folder.write("skin a.png", "");
    expectRefused({"voxelize", "parts.gltf", "--preview", "skin a.png"}, "skin a.png, which is read");
    folder.write("cube.obj", "mtllib cube.mtl\n");
    folder.write("cube.mtl", "map_Kd picture.png\n");
    folder.write("picture.png", "");
    expectRefused({"voxelize", "cube.obj", "--preview", "picture.png"}, "picture.png, which is read");
}

TEST_F(Paths, OfFilesThatASceneNamesAreInputsToo)
{
    folder.write("cube.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 0 0 1\nv 1 0 1\nv 0 1 1\nv 1 1 1\n"
                             "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n");
    ASSERT_EQ(run({"-q", "voxelize", "cube.obj", "--particles", "64", "-o", "cube.json"}).code, 0);
    folder.write("actor.json", R"({ "duration": 0.05,
        "objects": [{ "type": "actor", "file": "cube.json", "position": [0, 2, 0] }] })");
    expectRefused({"render", "actor.json", "-o", "out", "--stats", "sub/../cube.json"}, "cube.json, which is read");
    fs::create_hard_link(folder.path("cube.obj"), folder.path("film.mp4"));
    expectRefused({"render", "actor.json", "-o", "film.mp4"}, "cube.obj, which is read");
    fs::create_directory(folder.path("frames"));
    fs::create_symlink("../cube.json", folder.path("frames/frame_0002.png"));
    expectRefused({"render", "actor.json", "-o", "frames"}, "cube.json, which is read");
}

TEST_F(Paths, OfTwoOutputsAreTwo)
{
    const std::string twice = "would be written twice; give each output a name of its own";
    const auto refused = [&](std::vector<std::string> words) {
        words.insert(words.begin(), {"render", scene});
        expectRefused(words, twice);
    };
    refused({"-o", "film.mp4", "-o", "sub/../film.mp4"});
    refused({"-o", "new", "-o", "new/"});
    refused({"-o", "new", "--export", "ply=./new"});
    refused({"-o", "new", "--stats", "a.txt", "--export", "bodies=sub/../a.txt"});
    refused({"-o", "new", "--export", "measures=made/a.csv", "--export", "bodies=made/../made/a.csv"});
    fs::create_symlink("sub", folder.path("same"));
    refused({"-o", "same", "-o", "sub"});
    refused({"-o", "new", "--export", "measures=same/a.csv", "--export", "bodies=sub/a.csv"});
    const std::string mixed = "would have two outputs mixed; give one of them a file";
    expectRefused({"render", scene, "-o", "-", "--export", "bodies=-"}, mixed);
    expectRefused({"render", scene, "--export", "bodies=-", "--export", "measures=/dev/stdout"}, mixed);
    expectRefused({"render", scene, "-o", "a.mp4", "--stats", "./a.mp4/stats.json"},
                  "a.mp4 is to be a file, and ./a.mp4/stats.json to lie in it; give one another name");
    EXPECT_EQ(run({"-q", "render", scene, "-o", "new", "--stats", "new/stats.json"}).code, 0);
    EXPECT_EQ(run({"-q", "render", scene, "-o", "new", "--stats", "/dev/null", "--export", "bodies=/dev/null"}).code,
              0);
}

}  // namespace
}  // namespace knuckle
