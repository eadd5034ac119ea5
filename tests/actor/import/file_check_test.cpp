#include "sim/actor/import/file_check.h"
#include "sim/actor/import/import.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "sim/world/errors.h"
#include "tests/temp_folder.h"

namespace knuckle {
namespace {

class FileCheck : public testing::Test {
protected:
    /// What is said of a file, without its path.
    std::string refusal(const std::string& name, const std::string& text) const
    {
        const std::string path = folder.write(name, text);
        try {
            importModel(path);
        } catch (const InputError& error) {
            const std::string message = error.what();
            return message.starts_with(path + ": ") ? message.substr(path.size() + 2) : "without its path: " + message;
        }
        return "was read";
    }
    static std::string gltf(const std::string& uri)
    {
        return R"({ "asset": { "version": "2.0" }, "buffers": [{ "uri": ")" + uri + R"(", "byteLength": 840 }] })";
    }
    const test::TempFolder folder;
};

const char* const TETRAHEDRON = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";

TEST_F(FileCheck, NamesTheFileThatAGltfNeeds)
{
    EXPECT_EQ(refusal("walk.gltf", gltf("walk%20cycle.bin")),
              "its file 'walk cycle.bin' is not beside it: put it there, or export a .glb, which holds all");
    folder.write("walk cycle.bin", std::string(100, '\0'));
    EXPECT_EQ(refusal("walk.gltf", gltf("walk%20cycle.bin")),
              "its file 'walk cycle.bin' is cut off: 100 of 840 bytes are there; export the model again");
}

TEST_F(FileCheck, TellsWhatIsCutOff)
{
    for (const auto& [name, text] : {std::pair<const char*, std::string>{"half.gltf", gltf("a.bin").substr(0, 40)},
                                     {"half.bvh", "HIERARCHY\nROOT Hips\n{\n OFFSET 0 90"},
                                     {"empty.obj", "# nothing\n"}}) {
        const std::string message = refusal(name, text);
        EXPECT_TRUE(message.starts_with("it is cut off or damaged (")) << message;
        EXPECT_TRUE(message.ends_with("); export the model again")) << message;
    }
}

TEST_F(FileCheck, SaysWhichFileToGiveInsteadOfASkeletonOfOgre)
{
    for (const char* name : {"robot.skeleton", "robot.SKELETON.xml"})
        EXPECT_EQ(refusal(name, "<skeleton/>"),
                  "it is a skeleton of Ogre without its mesh: give the .mesh or .mesh.xml that goes with it");
}

TEST_F(FileCheck, SaysHowToRenameAGltfOfTheOtherKind)
{
    EXPECT_EQ(refusal("walk.v2.gltf", std::string("glTF\2\0\0\0\20\0\0\0more", 16)),
              "it is a binary glTF under the name of one of text: rename it to walk.v2.glb");
    EXPECT_EQ(refusal("walk.GLB", "\n" + gltf("a.bin")),
              "it is a glTF of text under the name of a binary one: rename it to walk.gltf");
}

TEST_F(FileCheck, NotesAMissingMaterialFileWhereItWouldBeSeen)
{
    const std::string path = folder.write("box.obj", std::string("mtllib gone.mtl\r\nusemtl a\n") + TETRAHEDRON);
    const Model drawn = importModel(path, {.surface = true});
    ASSERT_EQ(drawn.surface.notes.size(), 1u);
    EXPECT_EQ(drawn.surface.notes[0], "Material file 'gone.mtl' is not beside the model: drawn plain.");
    EXPECT_TRUE(importModel(path).surface.notes.empty());
    folder.write("gone.mtl", "newmtl a\n");
    EXPECT_TRUE(importModel(path, {.surface = true}).surface.notes.empty());
}

TEST_F(FileCheck, NotesAMeshWithoutTriangles)
{
    const std::string path = folder.write("box.obj",
                                          std::string(TETRAHEDRON) + "o whiskers\nv 2 0 0\nv 3 0 0\nl 5 6\n");
    const Model model = importModel(path);
    EXPECT_EQ(model.triangles.size(), 4u);
    EXPECT_EQ(std::ranges::count(model.notes, "Mesh 'whiskers' has no triangles and fills nothing."), 1);
}

}  // namespace
}  // namespace knuckle
