#include <cmath>
#include <cstring>

#include "app/json/json.h"
#include "render/picture/image.h"
#include "sim/rig/gltf/glb.h"
#include "sim/rig/import/import.h"
#include "tests/cli/cli_fixture.h"
#include "tests/places.h"

namespace knuckle {
namespace {

using test::RunResult;

class Voxelize : public test::CliTest {
protected:
    /// The line of a table that begins with a word, its columns one space apart.
    static std::string lineOf(const std::string& table, const std::string& word)
    {
        std::istringstream lines(table);
        for (std::string line; std::getline(lines, line);) {
            if (!line.starts_with(word + " ")) continue;
            std::istringstream words(line);
            std::string joined;
            for (std::string next; words >> next;) joined += (joined.empty() ? "" : " ") + next;
            return joined;
        }
        return "none";
    }
    const std::string figure = test::inSource("assets/models/humanoid.glb");
};

TEST_F(Voxelize, TellsEveryDecisionAndWhy)
{
    folder.write(
        "joints.json",
        R"({ "spine": "stiff", "foot.L": { "type": "hinge", "axis": [1, 0, 0], "limits": { "bend": [-30, 20] } },
                      "head": { "type": "ball", "axis": [0, 1, 0], "limits": { "swing": 40, "stiffness": 3 } } })");
    const RunResult result = run({"voxelize", figure, "--diameter", "0.04", "--merge", "hand*", "--keep", "clavicle*",
                                  "--joints", "joints.json"});
    ASSERT_EQ(result.code, 0) << result.err;
    const auto has = [&](const std::string& word, const std::string& text) {
        const std::string line = lineOf(result.out, word);
        EXPECT_NE(line.find(text), std::string::npos) << word << ": " << line;
    };
    has("hips", "- - - hips (name)");
    has("spine", "stiff 4 - spine (name, --joints)");
    has("thigh.R", "ball 1 cone 75, twist -45 to 68 thigh, right (name)");
    has("foot.L", "about x foot, left (name, --joints)");
    has("foot.L", "-30 to 20");
    has("head", "cone 40, twist all round, spring 3 N m/rad head (name, --joints)");
    EXPECT_NE(result.out.find("\nnote: forearm.L took in hand.L, as --merge says.\n"), std::string::npos);
    has("clavicle.L", "collar bone, left (name, --keep)");
    EXPECT_NE(result.out.find("\nnote: chest took in neck, too small for four particles that span space.\n"),
              std::string::npos);
    has("size:", "1.75 high");
    has("size:", "lowest point at a height of 0 m");
    has("pose:", "the file's rest pose");
    has("clip:", "dance, 8.00 s");
}

TEST_F(Voxelize, TellsItInLinesOfAScreensWidth)
{
    for (const char* diameter : {"0.03", "0.08"}) {
        std::istringstream lines(run({"voxelize", figure, "--diameter", diameter}).out);
        for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 120u) << line;
    }
}

TEST_F(Voxelize, AsksWhichOfTwoFiguresIsMeant)
{
    const Model model = importModel(figure, {.clips = false});
    folder.write("pair.glb", toGlb(std::vector{model, model}));
    const std::string choice = "; choose one by --skeleton NAME, or all as one by --skeleton '*'";
    expectError(run({"voxelize", "pair.glb"}), 2,
                "pair.glb: it holds 2 skeletons: hips (19 bones), hips#2 (19 bones)" + choice);
    expectError(run({"voxelize", "pair.glb", "--skeleton", "Hips"}), 2,
                "pair.glb: it has no skeleton 'Hips', but hips (19 bones), hips#2 (19 bones)" + choice);
    const RunResult result = run(
        {"voxelize", "pair.glb", "--skeleton", "hips#2", "-o", "actor.json", "--diameter", "0.05"});
    ASSERT_EQ(result.code, 0) << result.err;
    EXPECT_EQ(result.out.find("shin.L#2"), std::string::npos);
    EXPECT_NE(test::readText(folder.path("actor.json")).find("\"skeleton\": \"hips#2\""), std::string::npos);
    folder.write("doll.json", R"({ "diameter": 0.05, "duration": 1,
        "objects": [{ "type": "actor", "file": "actor.json", "skin": "mesh" }] })");
    EXPECT_EQ(run({"check", "doll.json"}).err, "");
}

TEST_F(Voxelize, SplitsAMeshIntoItsParts)
{
    folder.write("two.obj", "o red\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n"
                            "o blue\nv 2 0 0\nv 3 0 0\nv 2 1 0\nv 2 0 1\nf 5 7 6\nf 5 6 8\nf 6 7 8\nf 5 8 7\n");
    const RunResult result = run({"voxelize", "two.obj", "--split", "--diameter", "0.1", "-o", "two.json"});
    ASSERT_EQ(result.code, 0) << result.err;
    EXPECT_TRUE(lineOf(result.out, "red").ends_with("- - - part")) << lineOf(result.out, "red");
    EXPECT_NE(lineOf(result.out, "two:").find("2 bodies, 0 joints"), std::string::npos);
    folder.write("fall.json", R"({ "diameter": 0.1, "duration": 0.6, "render": { "width": 64, "height": 36 },
        "objects": [{ "type": "actor", "file": "two.json", "position": [0, 1, 0], "rotation": [20, 0, 0],
                      "skin": "mesh" }],
        "colliders": [{ "type": "box", "size": [0.8, 0.2, 4], "position": [0, 0.1, 0] }] })");
    EXPECT_EQ(run({"render", "fall.json", "--export", "bodies=fall.csv", "--frames", "36:36", "-q"}).err, "");
    // The heights of both in the last frame: one lies on the box, the other falls beside it.
    std::istringstream csv(test::readText(folder.path("fall.csv")));
    std::vector<float> heights;
    for (std::string line; std::getline(csv, line);) {
        if (!line.starts_with("36,")) continue;
        std::istringstream fields(line);
        std::string field;
        for (int column = 0; column < 6; ++column) std::getline(fields, field, ',');
        heights.push_back(std::stof(field));
    }
    ASSERT_EQ(heights.size(), 2u);
    EXPECT_GT(heights[0], heights[1] + 0.3f);
    EXPECT_EQ(run({"voxelize", "two.obj", "--split", "--keep", "red"}).code, 2);
    expectError(run({"voxelize", figure, "--split"}), 2,
                figure + ": it has a skeleton, which says what its bodies are: leave `split` away");
}

TEST_F(Voxelize, TellsWhatOfItsLooksIsMissing)
{
    folder.write("ramp.obj", "mtllib gone.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\n"
                             "f 1 4 3\n");
    const std::string missing = "\nnote: Material file 'gone.mtl' is not beside the model: drawn plain.\n";
    EXPECT_NE(run({"voxelize", "ramp.obj"}).out.find(missing), std::string::npos);
    folder.write("gone.mtl", "newmtl a\nmap_Kd paint.png\n");
    EXPECT_EQ(run({"voxelize", "ramp.obj"}).out.find(missing), std::string::npos);
}

/// Rows and columns, in a part of a picture, with colourful pixels, which the figure has and the ground has not.
struct Extent {
    uint32_t left = 10000, right = 0, top = 10000, bottom = 0;

    Extent(const Image& image, uint32_t from, uint32_t to)
    {
        for (uint32_t y = 0; y < image.height; ++y) {
            for (uint32_t x = from; x < to; ++x) {
                const uint8_t* p = &image.rgb[3 * (size_t{y} * image.width + x)];
                if (std::max({p[0], p[1], p[2]}) - std::min({p[0], p[1], p[2]}) < 40) continue;
                left = std::min(left, x);
                right = std::max(right, x);
                top = std::min(top, y);
                bottom = std::max(bottom, y);
            }
        }
    }
};

TEST_F(Voxelize, PreviewIsFilledByTheFigureFromFrontAndSide)
{
    const RunResult result = run({"voxelize", figure, "--diameter", "0.05", "--preview", "figure.png", "-q"});
    ASSERT_EQ(result.code, 0) << result.err;
    const Image image = readImage(folder.path("figure.png"));
    ASSERT_EQ(image.width, 1280u);
    ASSERT_EQ(image.height, 720u);
    // The legend is at the left end of the left half.
    const Extent front(image, 100, 640), side(image, 640, 1280);
    for (const Extent& view : {front, side}) {
        EXPECT_NEAR(view.top, 0.04 * 720, 14);
        EXPECT_NEAR(view.bottom, 0.96 * 720, 14);
    }
    EXPECT_NEAR(0.5 * (front.left + front.right), 320, 6) << "both arms, or the legs";
    EXPECT_LT(side.right - side.left, 0.5 * (front.right - front.left)) << "the figure is less deep than wide";
}

TEST_F(Voxelize, PreviewsWhatHasNoSkeletonAndWhatHasNoMesh)
{
    folder.write("tetrahedron.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n");
    folder.write("bones.bvh",
                 "HIERARCHY\nROOT hips\n{\nOFFSET 0 0 0\nCHANNELS 3 Zrotation Xrotation Yrotation\n"
                 "JOINT spine\n{\nOFFSET 0 0.5 0\nCHANNELS 3 Zrotation Xrotation Yrotation\n"
                 "End Site\n{\nOFFSET 0.2 0.5 0\n}\n}\n}\nMOTION\nFrames: 1\nFrame Time: 0.1\n0 0 0 0 0 0\n");
    for (const char* model : {"tetrahedron.obj", "bones.bvh"}) {
        const RunResult result = run({"voxelize", model, "--preview", "picture.png"});
        ASSERT_EQ(result.code, 0) << result.err;
        EXPECT_EQ(readImage(folder.path("picture.png")).width, 1280u) << model;
    }
}

TEST_F(Voxelize, ParticlesOfTheActorFileHaveTheirNumbersInExports)
{
    ASSERT_EQ(run({"voxelize", figure, "--diameter", "0.1", "-o", "actor.json"}).code, 0);
    folder.write("dolls.json", R"({ "diameter": 0.1, "duration": 0.02, "render": { "width": 64, "height": 36 },
        "objects": [{ "type": "actor", "file": "actor.json", "position": [0, 1, 0],
                      "repeat": { "counts": [2, 1, 1], "spacing": [3, 1, 1] } }] })");
    const RunResult result = run({"render", "dolls.json", "--frames", "1:1", "--export", "ply=ply"});
    ASSERT_EQ(result.code, 0) << result.err;
    const Json actor = parseJson(test::readText(folder.path("actor.json")), "actor");
    const Json& particles = actor["particles"];
    const std::string ply = test::readText(folder.path("ply/frame_0001.ply"));
    const size_t start = ply.find("end_header\n") + 11;
    constexpr size_t ROW = 9 * 4;  // id, position, velocity, body, material
    ASSERT_EQ(ply.size() - start, 2 * particles.size() * ROW);
    for (size_t row = 0; row < 2 * particles.size(); ++row) {
        uint32_t id = 0;
        float position[3] = {};
        std::memcpy(&id, ply.data() + start + row * ROW, 4);
        std::memcpy(position, ply.data() + start + row * ROW + 4, sizeof position);
        ASSERT_EQ(id, row);
        const Json& rest = particles[row % particles.size()];
        ASSERT_NEAR(position[1] - rest[1].get<float>(), 1.0f, 1e-5f) << id;
        ASSERT_NEAR(position[2] - rest[2].get<float>(), 0.0f, 1e-5f) << id;
        const float shift = position[0] - rest[0].get<float>();
        ASSERT_NEAR(shift, row < particles.size() ? -1.5f : 1.5f, 1e-5f) << id;
    }
}

}  // namespace
}  // namespace knuckle
