#include <cstdlib>
#include <filesystem>

#include "tests/cli/cli_fixture.h"

namespace knuckle {
namespace {

namespace fs = std::filesystem;
using test::RunResult;

/// Arguments of options: endings, numbers, nothing.
using Words = test::CliTest;

TEST_F(Words, ThatAreNoCommandAreRefusedWithTheNearest)
{
    RunResult result = run({"rendr", scene});
    EXPECT_EQ(result.code, 2);
    EXPECT_EQ(result.err, "knuckle: rendr is no command; did you mean \"render\"?; see knuckle --help\n");
    result = run({});
    EXPECT_EQ(result.code, 2);
    EXPECT_EQ(result.err, "knuckle: A subcommand is required; see knuckle --help\n");
}

TEST_F(Words, OfAnotherKindOfFileAreRefusedWithTheListOfWhatIsKnown)
{
    const std::string films = "films are written as .mp4, .mov, .mkv, .webm, .gif, .webp or .apng, "
                              "frames into a folder";
    for (const char* path : {"film.xyz", "a.tiff", "f.3gp", "v1.2b"}) {
        const RunResult result = run({"render", scene, "-o", path});
        EXPECT_EQ(result.code, 2) << path;
        EXPECT_NE(result.err.find(films), std::string::npos) << result.err;
    }
    const struct {
        std::vector<std::string> words;
        const char* message;
    } cases[] = {
        {{"voxelize", "none.obj", "-o", "spot.ply"},
         "-o spot.ply: an actor is written as .json or .npz or .urdf or .mjcf"},
        {{"voxelize", "none.obj", "-o", "spot"}, "-o spot: an actor is written as .json or .npz or .urdf or .mjcf"},
        {{"voxelize", "none.obj", "--preview", "spot.jpg"}, "--preview spot.jpg: a picture is written as .png"},
        {{"compare", "a.png", "b.png", "--difference", "d.bmp"}, "--difference d.bmp: a picture is written as .png"},
        {{"render", scene, "--export", "gltf=a.bvh"}, "--export gltf=a.bvh: a motion as glTF is written as .glb"},
        {{"render", scene, "--export", "bvh=a.glb"}, "--export bvh=a.glb: a motion as BVH is written as .bvh"},
        {{"render", scene, "--export", "bodies=a.glb"}, "--export bodies=a.glb: a table is written as .csv or .txt"},
        {{"render", scene, "--export", "ply=a.ply"}, "--export ply=a.ply: frames are written into a folder"},
        {{"render", scene, "--export", "gltf=a.gltf"},
         "--export gltf=a.gltf: it is written as binary glTF; name it a.glb"},
        {{"render", scene, "--export", "obj=x"},
         "--export obj=x: must be ply=FOLDER, vtk=FOLDER, bgeo=FOLDER, bodies=FILE.csv, measures=FILE.csv, "
         "bvh=FILE.bvh, "
         "gltf=FILE.glb, surface=FOLDER, vdb=FOLDER or "
         "layers=FOLDER"},
        {{"render", scene, "--stats", "a.csv"}, "--stats a.csv: a file of figures is written as .json or .txt"},
    };
    for (const auto& entry : cases) {
        const RunResult result = run(entry.words);
        EXPECT_EQ(result.code, 2) << entry.message;
        EXPECT_TRUE(result.err.starts_with(std::string("knuckle: ") + entry.message)) << result.err;
    }
    EXPECT_TRUE(madeFiles().empty());
}

TEST_F(Words, EndInAnyCaseAndFoldersInWhatIsNoEnding)
{
    folder.write("big.json", R"({ "name": "a film.xyz", "duration": 0.02, "objects": [{ "type": "joined" }],
                                  "render": { "width": 16, "height": 16 } })");
    for (const char* path : {"v1.2", "dir.d/", "run.2024-05", ".hidden"})
        EXPECT_EQ(run({"-q", "render", "big.json", "-o", path}).code, 0) << path;
    EXPECT_EQ(run({"-q", "render", "big.json", "-o", "dir.d"}).code, 0) << "a folder that is there";
    EXPECT_EQ(run({"-q", "render", "big.json", "--export", "gltf=A.GLB", "--stats", "S.Json"}).code, 0);
    EXPECT_TRUE(fs::exists(folder.path("A.GLB")) && fs::exists(folder.path("out/a film.xyz/frame_0001.png")));
}

TEST_F(Words, ThatAreNoFiniteNumberAreRefusedByName)
{
    for (const std::string value : {"nan", "-nan", "inf", "-inf", "Infinity", "1e999"}) {
        for (const std::vector<std::string>& words :
             std::vector<std::vector<std::string>>{{"render", scene, "--fps", value},
                                                   {"render", scene, "--set", "duration=" + value},
                                                   {"check", scene, "--set", "solver.substeps=" + value},
                                                   {"bench", "--set", "solver.iterations=" + value},
                                                   {"bench", "--steps", value},
                                                   {"bench", "--objects", value},
                                                   {"compare", "a.png", "b.png", "--max-changed", value},
                                                   {"compare", "a.png", "b.png", "--threshold", value},
                                                   {"voxelize", "none.obj", "--height", value},
                                                   {"voxelize", "none.obj", "--scale", value},
                                                   {"voxelize", "none.obj", "--diameter", value},
                                                   {"voxelize", "none.obj", "--particles", value}}) {
            const RunResult result = run(words);
            EXPECT_EQ(result.code, 2) << words[words.size() - 2] << " " << value;
            EXPECT_TRUE(test::isOneLine(result.err)) << result.err;
            EXPECT_TRUE(result.err.starts_with("knuckle: " + words[words.size() - 2])) << result.err;
        }
    }
    expectError(run({"check", scene, "--set", "duration=1e39"}), 2, scene + ": /duration: 1e+39 is too large");
    EXPECT_EQ(run({"check", scene, "--set", "name=\"nan\""}).code, 0);
}

TEST_F(Words, OfARateMayBeAFraction)
{
    for (const std::string rate : {"24000/1001", "30/1", "25"}) {
        EXPECT_EQ(run({"-q", "render", scene, "--fps", rate}).code, 0) << rate;
        EXPECT_EQ(run({"check", scene, "--set", "fps=" + rate}).code, 0) << rate;
    }
    EXPECT_NE(run({"check", scene, "--set", "fps=24000/1001", "--set", "duration=10"}).out.find("(240 frames)"),
              std::string::npos);
    if (std::system("command -v ffmpeg >/dev/null && command -v ffprobe >/dev/null") == 0) {
        ASSERT_EQ(run({"-q", "render", scene, "--fps", "24000/1001", "-o", "film.mp4"}).code, 0);
        const std::string probe = "ffprobe -v error -show_entries stream=r_frame_rate -of csv=p=0 '" +
                                  folder.path("film.mp4") + "' | grep -qx 24000/1001";
        EXPECT_EQ(std::system(probe.c_str()), 0);
    }
    for (const std::string rate : {"1/0", "0/0", "24000/", "/1001", "1/2/3", "nan/1", "5/1", "1e999/1"})
        EXPECT_EQ(run({"-q", "render", scene, "--fps", rate}).code, 2) << rate;
}

TEST_F(Words, MayNotBeEmpty)
{
    for (const std::vector<std::string>& words :
         std::vector<std::vector<std::string>>{{"render", scene, "-o", ""},
                                               {"render", scene, "--stats", ""},
                                               {"render", scene, "--fps", ""},
                                               {"voxelize", "none.obj", "-o", ""},
                                               {"voxelize", "none.obj", "--joints", ""},
                                               {"compare", "a.png", "b.png", "--difference", ""},
                                               {"check", ""}}) {
        const RunResult result = run(words);
        EXPECT_EQ(result.code, 2) << words[words.size() - 2];
        EXPECT_NE(result.err.find(": its value is empty; give one, or leave it out\n"), std::string::npos)
            << result.err;
    }
    EXPECT_TRUE(madeFiles().empty());
}

TEST_F(Words, OfAPlaceMayBeAPointerAsErrorsTellIt)
{
    EXPECT_NE(run({"check", scene, "--set", "/render/width=0"}).err.find("/render/width: "), std::string::npos);
    EXPECT_EQ(run({"check", scene, "--set", "/objects/0/position=[0,1,0]"}).code, 0);
    expectError(run({"check", scene, "--set", "/colliders/2/size=1"}), 2,
                "--set /colliders/2/size: \"2\" is not one of the list's 1 places; they count from 0");
}

TEST_F(Words, OfAnAnimationNameAClip)
{
    for (const char* field : {"animation", "pose"})
        expectError(run({"check", scene, "--set",
                         std::string("objects=[{\"type\":\"actor\",\"file\":\"a.glb\",\"") + field + "\":{}}]"}),
                    2,
                    scene + ": /objects/0/" + field +
                        ": names no clip; give its `clip` (`knuckle voxelize` lists them), or the `file` of another "
                        "model");
}

TEST_F(Words, OfAMeshWithoutAVolumeSaySo)
{
    folder.write("quad.obj", "v 0 0 0\nv 1 0 0\nv 0 0 1\nv 1 0 1\nf 1 3 4 2\n");
    const RunResult result = run({"voxelize", "quad.obj"});
    EXPECT_EQ(result.code, 0) << result.err;
    EXPECT_NE(result.out.find("fill: the mesh encloses no volume; its surface is"), std::string::npos) << result.out;
}

}  // namespace
}  // namespace knuckle
