#include <gtest/gtest.h>

#include "app/scene/scene_file.h"
#include "sim/base/errors.h"
#include "tests/temp_folder.h"

namespace knuckle {
namespace {

/// A rope from a position above the cube, with more `fields`, which may be wrong on purpose.
#define ROPE(fields) R"("type": "rope", "from": [0, 1, 0], )" fields
#define CLOTH(fields) R"("type": "cloth", )" fields

/// The error, without the file's name, of loading a scene with this object and a cube of 0.3 m at the origin.
std::string messageOf(const std::string& object)
{
    const test::TempFolder folder;
    folder.write("line.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n");
    folder.write("sheet.obj", "v 0 0 0\nv 1 0 0\nv 0 0 1\nf 1 2 3\n");
    const std::string path = folder.write(
        "scene.json",
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

TEST(SceneRopes, TellWhatIsWrongWithRopes)
{
    EXPECT_EQ(messageOf(ROPE(R"("start": "free")")), ": /objects/1: \"to\" is missing; add it: Where it ends.");
    EXPECT_EQ(messageOf(ROPE(R"("to": [0, 2, 0], "start": "fixd")")),
              ": /objects/1/start: \"fixd\" is unknown; did you mean \"fixed\"?");
    EXPECT_EQ(messageOf(ROPE(R"("to": [0, 2, 0], "compliance": -1)")),
              ": /objects/1/compliance: -1 is below the minimum 0 [m/N]");
    EXPECT_EQ(messageOf(ROPE(R"("to": [0, 2, 0], "bendCompliance": 0)")),
              ": /objects/1/bendCompliance: 0 must be above 0 [m/N]");
    EXPECT_EQ(messageOf(ROPE(R"("to": [0, 1, 0])")),
              ": /objects/1: the rope has no length; move its ends apart or set length");
    EXPECT_EQ(messageOf(ROPE(R"("to": [0, 2, 0], "length": 0.5)")),
              ": /objects/1: length 0.5 m of the rope is less than the 1 m between its ends; make it longer or bring "
              "them nearer");
    EXPECT_EQ(messageOf(ROPE(R"("to": [0, 2, 0], "length": 10000, "repeat": {"counts": [20, 1, 1]})")),
              ": /objects/1: brings the scene to 2000027 particles, the limit is 1000000; raise /diameter, or make it "
              "smaller or fewer");
}

TEST(SceneRopes, TellWhatTheyCannotBeTiedTo)
{
    EXPECT_EQ(messageOf(ROPE(R"("to": [0, 2, 0], "end": {"object": "cub"})")),
              ": /objects/1/end/object: there is no object \"cub\"; did you mean \"cube\"?");
    EXPECT_EQ(messageOf(ROPE(R"("to": [0, 2, 0], "end": {"object": "cube"})")),
              ": /objects/1/end: \"cube\" is 1.9 m away from here, its nearest particle at [0, 0.1, 0]; begin there");
    EXPECT_EQ(messageOf(ROPE(R"("to": [0, 0.1, 0], "end": {"object": "cube", "body": "x"})")),
              ": /objects/1/end/body: object \"cube\" has no body \"x\" with particles of its own; known: body");
    EXPECT_EQ(messageOf(CLOTH(R"("position": [0, 2, 0], "attach": [{"point": [0, 0, 0], "object": "cube"}])")),
              ": /objects/1/attach/0: \"cube\" is 1.9 m away from here, its nearest particle at [0, 0.1, 0]; begin "
              "there");
}

TEST(SceneRopes, TellWhatIsWrongWithCloth)
{
    EXPECT_EQ(messageOf(CLOTH(R"("size": [0, 1])")), ": /objects/1/size/0: 0 must be above 0");
    EXPECT_EQ(messageOf(CLOTH(R"("size": [500, 500])")),
              ": /objects/1: brings the scene to 25010028 particles, the limit is 1000000; raise /diameter, or make it "
              "smaller or fewer");
    EXPECT_EQ(messageOf(CLOTH(R"("hold": ["nearleft"])")),
              ": /objects/1/hold/0: \"nearleft\" is unknown; did you mean \"nearLeft\"?");
    EXPECT_TRUE(messageOf(CLOTH(R"("file": "none.obj")")).starts_with(": /objects/1/file: there is no file "));
    EXPECT_EQ(messageOf(CLOTH(R"("file": "line.obj", "scale": 1)")),
              ": /objects/1: the cloth's mesh has no area; give one with triangles");
    EXPECT_EQ(messageOf(CLOTH(R"("file": "sheet.obj", "scale": 1, "hold": ["left"])")),
              ": /objects/1/hold: a model has no edges by these names; use pins instead");
    EXPECT_EQ(
        messageOf(CLOTH(R"("file": "sheet.obj", "scale": 1, "pins": [[0, 0, 0], [0, 2, 0]])")),
        ": /objects/1/pins/1: the nearest particle is 2 m away, at [0, 0, 0], and may be 0.1 m, a diameter; put the "
        "pin there");
    EXPECT_EQ(messageOf(CLOTH(R"("stretchCompliance": -1)")),
              ": /objects/1/stretchCompliance: -1 is below the minimum 0 [m/N]");
}

TEST(SceneRopes, AreMadeWhereNothingIsWrong)
{
    EXPECT_EQ(messageOf(ROPE(R"("to": [0, 0.15, 0], "end": {"object": "cube"})")), "no error");
    EXPECT_EQ(messageOf(CLOTH(R"("file": "sheet.obj", "scale": 1, "position": [0, 1, 0], "pins": [[0, 0, 0]])")),
              "no error");
}

}  // namespace
}  // namespace knuckle
