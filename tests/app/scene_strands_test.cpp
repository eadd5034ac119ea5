#include <gtest/gtest.h>

#include "app/scene_file.h"
#include "sim/world/errors.h"
#include "tests/temp_folder.h"

namespace knuckle {
namespace {

/// What loading a scene of a cube of 0.3 m at the origin and this object says behind the file's name.
std::string messageOf(const std::string& object)
{
    const test::TempFolder folder;
    folder.write("line.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n");
    folder.write("sheet.obj", "v 0 0 0\nv 1 0 0\nv 0 0 1\nf 1 2 3\n");
    const std::string path = folder.write("scene.json",
        R"({ "objects": [{ "type": "rigid", "shape": "box", "size": [0.3, 0.3, 0.3], "name": "cube" }, {)" + object +
        "}] }");
    try {
        loadScene(path, {});
    } catch (const InputError& error) {
        const std::string message = error.what();
        return message.starts_with(path) ? message.substr(path.size()) : message;
    }
    return "no error";
}

TEST(SceneStrands, TellWhatIsWrongWithRopes)
{
    EXPECT_EQ(messageOf(R"("type": "rope", "from": [0, 1, 0])"), "");
    EXPECT_EQ(messageOf(R"("type": "rope", "from": [0, 1, 0], "to": [0, 2, 0], "length": 0.5)"), "");
    EXPECT_EQ(messageOf(R"("type": "rope", "from": [0, 1, 0], "to": [0, 2, 0], "end": {"object": "cub"})"), "");
    EXPECT_EQ(messageOf(R"("type": "rope", "from": [0, 1, 0], "to": [0, 2, 0], "end": {"object": "cube"})"), "");
    EXPECT_EQ(messageOf(R"("type": "rope", "from": [0, 1, 0], "to": [0, 0.1, 0], "end": {"object": "cube", "body": "x"})"), "");
    EXPECT_EQ(messageOf(R"("type": "rope", "from": [0, 1, 0], "to": [0, 2, 0], "start": "fixd")"), "");
    EXPECT_EQ(messageOf(R"("type": "rope", "from": [0, 1, 0], "to": [0, 2, 0], "compliance": -1)"), "");
    EXPECT_EQ(messageOf(R"("type": "rope", "from": [0, 1, 0], "to": [0, 2, 0], "bendCompliance": 0)"), "");
    EXPECT_EQ(messageOf(R"("type": "rope", "from": [0, 1, 0], "to": [0, 2, 0], "length": 10000, "repeat": {"counts": [20, 1, 1]})"), "");
    EXPECT_EQ(messageOf(R"("type": "rope", "from": [0, 1, 0], "to": [0, 1, 0])"), "");
}

TEST(SceneStrands, TellWhatIsWrongWithCloth)
{
    EXPECT_EQ(messageOf(R"("type": "cloth", "size": [0, 1])"), "");
    EXPECT_EQ(messageOf(R"("type": "cloth", "size": [500, 500])"), "");
    EXPECT_EQ(messageOf(R"("type": "cloth", "hold": ["nearleft"])"), "");
    EXPECT_EQ(messageOf(R"("type": "cloth", "file": "none.obj")"), "");
    EXPECT_EQ(messageOf(R"("type": "cloth", "file": "line.obj", "scale": 1)"), "");
    EXPECT_EQ(messageOf(R"("type": "cloth", "file": "sheet.obj", "scale": 1, "hold": ["left"])"), "");
    EXPECT_EQ(messageOf(R"("type": "cloth", "position": [0, 2, 0], "attach": [{"point": [0, 0, 0], "object": "cube"}])"), "");
    EXPECT_EQ(messageOf(R"("type": "cloth", "stretchCompliance": -1)"), "");
}

TEST(SceneStrands, AreFoundWithTheObjectsThatTheyAreTiedTo)
{
    EXPECT_EQ(messageOf(R"("type": "rope", "from": [0, 1, 0], "to": [0, 0.15, 0], "end": {"object": "cube"})"), "no error");
    EXPECT_EQ(messageOf(R"("type": "cloth", "file": "sheet.obj", "scale": 1, "pins": [[0, 0, 0]])"), "no error");
}

}  // namespace
}  // namespace knuckle
