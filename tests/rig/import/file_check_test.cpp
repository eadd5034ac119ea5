#include "sim/rig/import/file_check.h"
#include "sim/rig/import/import.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "sim/base/errors.h"
#include "tests/temp_folder.h"

namespace knuckle {
namespace {

class FileCheck : public testing::Test {
protected:
    /// The error message for a file, without its path.
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
    for (const auto& [name, text] :
         {std::pair<const char*, std::string>{"half.gltf", gltf("a.bin").substr(0, 40)},
          {"half.bvh", "HIERARCHY\nROOT Hips\n{\n OFFSET 0 90"},
          {"half.dae", "<?xml version=\"1.0\"?>\n<COLLADA version=\"1.4.1\"><asset><up_a"}}) {
        const std::string message = refusal(name, text);
        EXPECT_TRUE(message.starts_with("it is cut off or damaged (")) << message;
        EXPECT_TRUE(message.ends_with("); export the model again")) << message;
    }
}

TEST_F(FileCheck, SaysWhatAnOldFbxIs)
{
    const std::string binary = "Kaydara FBX Binary  ";
    for (const auto& [version, text] :
         {std::pair<const char*, std::string>{
              "6.1", "; FBX 6.1.0 project file\n; ----\n\nFBXHeaderExtension:  {\n    FBXHeaderVersion: 1003\n    "
                     "FBXVersion: 6100\n}\nObjects:  {\n}\n"},
          {"6.1", binary + std::string("\0\x1a\0\xd4\x17\0\0", 7) + std::string(200, '\0')},
          {"5.0", "; FBX 5.0 project file\nFBXHeaderExtension:  {\nFBXVersion: 5000\n}\n"}})
        EXPECT_EQ(refusal("old.fbx", text), std::string("it is an FBX of version ") + version +
                                                ", as programs wrote before 2011, which is not read: convert it to FBX "
                                                "2011 or later, or to glTF");
}

TEST_F(FileCheck, SaysOfAFileWithoutAMeshThatItHasNone)
{
    const std::string fbx = "; FBX 7.4.0 project file\nFBXHeaderExtension:  {\nFBXHeaderVersion: 1003\n"
                            "FBXVersion: 7400\n}\n",
                      dae = "<?xml version=\"1.0\"?>\n<COLLADA xmlns=\"http://www.collada.org/2005/11/COLLADASchema\" "
                            "version=\"1.4.1\"><asset/>",
                      ply = "ply\nformat ascii 1.0\nelement vertex 0\nproperty float x\nproperty float y\n"
                            "property float z\nelement face 0\nproperty list uchar int vertex_indices\nend_header\n";
    const std::string json = R"({"asset":{"version":"2.0"}} )";
    const std::string glb = std::string("glTF\2\0\0\0\60\0\0\0\34\0\0\0JSON", 20) + json;
    const std::string camera = R"({ "asset": { "version": "2.0" }, "scene": 0, "scenes": [{ "nodes": [0] }],
        "nodes": [{ "camera": 0 }],
        "cameras": [{ "type": "perspective", "perspective": { "yfov": 1, "znear": 0.1 } }] })";
    for (const auto& [name, text] :
         {std::pair<const char*, std::string>{"json.glb", glb},
          {"json.gltf", json},
          {"camera.gltf", camera},
          {"empty.obj", "# nothing\n"},
          {"points.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n"},
          {"header.fbx", fbx},
          {"empty.fbx", fbx + "Objects:  {\n}\nConnections:  {\n}\n"},
          {"camera.fbx", fbx + "Objects:  {\nNodeAttribute: 1, \"NodeAttribute::\", \"Camera\" {\n}\nModel: 2, "
                               "\"Model::Camera\", \"Camera\" {\nVersion: 232\n}\n}\nConnections:  {\n"
                               "C: \"OO\",2,0\nC: \"OO\",1,2\n}\n"},
          {"bare.dae", dae + "</COLLADA>\n"},
          {"node.dae", dae + "<library_visual_scenes><visual_scene id=\"s\"><node id=\"a\"/></visual_scene>"
                             "</library_visual_scenes><scene><instance_visual_scene url=\"#s\"/></scene></COLLADA>\n"},
          {"empty.ply", ply},
          {"empty.stl", "solid a\nendsolid a\n"},
          {"binary.stl", std::string(84, '\0')},
          {"empty.off", "OFF\n0 0 0\n"}})
        EXPECT_EQ(refusal(name, text), "it holds neither triangles nor a skeleton: export a mesh") << name;
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
    ASSERT_EQ(drawn.surface.missing.size(), 1u);
    EXPECT_EQ(drawn.surface.missing[0], "Material file 'gone.mtl' is not beside the model: drawn plain.");
    EXPECT_TRUE(importModel(path).surface.missing.empty());
    folder.write("gone.mtl", "newmtl a\n");
    EXPECT_TRUE(importModel(path, {.surface = true}).surface.missing.empty());
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
