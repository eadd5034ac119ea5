#include <gtest/gtest.h>

#include "app/scene/scene_file.h"
#include "sim/base/errors.h"
#include "tests/temp_folder.h"

namespace knuckle {
namespace {

struct BadScene {
    const char* name;
    const char* text;
    const char* message;  ///< The part after the file's name.
};

/// A scene of one box with `fields` added at the top.
#define WITH(fields) R"({ "objects": [{ "type": "rigid", "shape": "box" }], )" fields " }"
#define EMITTER(fields) R"({ "emitters": [{ )" fields " }] }"
#define OBJECT(fields) R"({ "objects": [{ )" fields " }] }"

const BadScene BAD_SCENES[] = {
    {"UnknownField", WITH(R"("durration": 3)"), ": /durration: unknown field; did you mean \"duration\"?"},
    {"UnknownNestedField", WITH(R"("solver": {"substep": 3})"),
     ": /solver/substep: unknown field; did you mean \"substeps\"?"},
    {"FarFetchedField", WITH(R"("light": {"zzzzzzzz": 3})"),
     ": /light/zzzzzzzz: unknown field; known: direction, intensity, softness, bounce, color, sky, turbidity, "
     "skyColor, groundColor"},
    {"BelowRange", WITH(R"("solver": {"substeps": -1})"), ": /solver/substeps: -1 is below the minimum 0"},
    {"AboveRange", WITH(R"("fps": 1000)"), ": /fps: 1000 is above the maximum 480 [1/s]"},
    {"ZeroDuration", WITH(R"("duration": 0)"), ": /duration: 0 must be above 0 [s]"},
    {"NegativeRadius", OBJECT(R"("type": "rigid", "shape": "sphere", "radius": -0.5)"),
     ": /objects/0/radius: -0.5 must be above 0 [m]"},
    {"NegativeDiameter", WITH(R"("diameter": -1)"), ": /diameter: -1 is below the minimum 0.001 [m]"},
    {"WrongType", WITH(R"("duration": "long")"), ": /duration: is \"long\" (a string), must be a number [s]"},
    {"WrongIntegerType", WITH(R"("solver": {"substeps": 1.5})"),
     ": /solver/substeps: is 1.5 (a number), must be an integer"},
    {"WrongVectorLength", WITH(R"("solver": {"gravity": [0, 1]})"),
     ": /solver/gravity: is an array of 2, must be an array of 3 numbers [m/s2]"},
    {"WrongVectorElement", WITH(R"("camera": {"target": [0, "up", 0]})"),
     ": /camera/target/1: is \"up\" (a string), must be a number"},
    {"WrongRoot", "[1, 2]", ": /: is an array of 2, must be an object"},
    {"WrongSolverType", WITH(R"("solver": 3)"), ": /solver: is 3 (a number), must be a string or an object"},
    {"UnknownPreset", WITH(R"("solver": "papr")"), ": /solver: \"papr\" is unknown; did you mean \"paper\"?"},
    {"UnknownWord", WITH(R"("render": {"colorBy": "bod"})"),
     ": /render/colorBy: \"bod\" is unknown; did you mean \"body\"?"},
    {"NoObjects", "{}", ": /: \"objects\" is missing; add it: What moves."},
    {"EmptyObjects", R"({"objects": []})", ": /objects: is an array of 0, must be at least 1"},
    {"NoType", OBJECT(R"("shape": "box")"),
     ": /objects/0: \"type\" is missing; known: rigid, soft, joined, actor, grains, fluid, rope, cloth, joint, "
     "gear"},
    {"UnknownType", OBJECT(R"("type": "joind")"), ": /objects/0/type: \"joind\" is unknown; did you mean \"joined\"?"},
    {"UnknownShape", OBJECT(R"("type": "rigid", "shape": "cone")"),
     ": /objects/0/shape: \"cone\" is unknown; known: box, sphere, capsule, mesh"},
    {"FixedSoftBody", OBJECT(R"("type": "soft", "shape": "box", "fixed": true)"),
     ": /objects/0/fixed: a soft body cannot be fixed; use type \"rigid\", or pins"},
    {"LimitOfAnotherJoint", OBJECT(R"("type": "joined", "joints": ["hinge", "stiff"], "limits": {"swing": 30})"),
     ": /objects/0/limits/swing: is no limit of a hinge or stiff joint; a ball has `swing`, `cone` and `twist`, a "
     "hinge `bend`, a universal joint `bend` and `secondBend`"},
    {"RestBeyondALimit", OBJECT(R"("type": "joined", "joints": ["hinge"], "limits": {"bend": [10, 30]})"),
     ": the joint of \"body_1\" and \"body_2\": the turn from 10 to 30 degrees must be within -180 to 180 and contain "
     "0, the rest pose"},
    {"ConeThatRestLeaves", OBJECT(R"("type": "joined", "limits": {"swing": 30, "cone": [1, 1, 0]})"),
     ": the joint of \"body_1\" and \"body_2\": at rest the axis leaves the middle of its cone by 45 degrees, more "
     "than the swing of 30; turn the cone or widen it"},
    {"NarrowCone", OBJECT(R"("type": "joined", "limits": {"swing": 0})"),
     ": /objects/0/limits/swing: 0 is below the minimum 1 [degrees]"},
    {"LimitsOfThePaper", R"({ "solver": "paper", "objects": [{ "type": "joined", "limits": { "swing": 30 } }] })",
     ": the paper's solver has no joint limits; take them away, or use solver method impulse"},
    {"LimitsAllAroundALoop",
     OBJECT(R"("type": "joined", "bodies": 4, "hold": "both", "joints": ["ball"], "limits": {"swing": 30})"),
     ": the joint of \"body_3\" and \"body_4\" closes a loop of joints with limits, which cannot be; leave one joint "
     "of "
     "the loop without"},
    {"NegativeTearForce", OBJECT(R"("type": "joined", "tearForce": -1)"),
     ": /objects/0/tearForce: -1 is below the minimum 0 [N]"},
    {"TearingOfThePaper", R"({ "solver": "paper", "objects": [{ "type": "joined", "tearTorque": 30 }] })",
     ": the paper's solver has no joints that tear; take `tearForce`, `tearTorque` and `releaseTime` away, or use "
     "solver method impulse"},
    {"PinBesideSoftBody",
     OBJECT(R"("type": "soft", "shape": "box", "size": [1, 1, 1], "pins": [[0, 0.5, 0], [0, 1, 0]])"),
     ": /objects/0/pins/1: the nearest particle is 0.555 m away, at [-0.05, 0.45, -0.05], and may be 0.1 m, a "
     "diameter; "
     "put the pin there"},
    {"ZeroStiffness", WITH(R"("materials": {"a": {"stiffness": 0}})"),
     ": /materials/a/stiffness: 0 is below the minimum 1 [Pa]"},
    {"PaperWithSoftBody", R"({ "solver": "paper", "objects": [{ "type": "soft", "shape": "box" }] })",
     ": soft body \"object_1\": the paper's solver has none; use solver method impulse"},
    {"FieldOfAnotherShape", OBJECT(R"("type": "rigid", "shape": "box", "radius": 1)"),
     ": /objects/0/radius: unknown field; known: type, shape, size, name, visible, draw, position, rotation, "
     "velocity, spin, material, motion, fixed, release, repeat"},
    {"MeshWithoutFile", OBJECT(R"("type": "rigid", "shape": "mesh")"),
     ": /objects/0: \"file\" is missing; add it: Path relative to the scene file."},
    {"UnknownMaterial", OBJECT(R"("type": "rigid", "shape": "box", "material": "wod")"),
     ": /objects/0/material: there is no material \"wod\"; known: default, water"},
    {"FrictionTheWrongWayRound", WITH(R"("materials": {"ice": {"staticFriction": 0.1, "kineticFriction": 0.2}})"),
     ": /materials/ice/kineticFriction: 0.2 is above staticFriction, 0.1; lower it or raise the other"},
    {"AxisAlongTheChain", OBJECT(R"("type": "joined", "axis": [1, 0, 0])"),
     ": /objects/0/axis: must not be zero or along x, the chain's own direction; for instance [0, 0, 1]"},
    {"UnknownFollowed", WITH(R"("camera": {"kind": "follow", "follow": "dol"})"),
     ": /camera/follow: there is no object \"dol\"; known: object_1"},
    {"DarkLight", WITH(R"("light": {"direction": [0, 0, 0]})"), ": /light/direction: must not be zero"},
    {"TwoMillionParticles", OBJECT(R"("type": "rigid", "shape": "box", "size": [20, 20, 5])"),
     ": /objects/0: brings the scene to 2000000 particles, the limit is 1000000; raise /diameter, or make it smaller "
     "or fewer"},
    {"ParticlesBeyondCounting",
     OBJECT(R"("type": "rigid", "shape": "sphere", "radius": 9000, "repeat": {"counts": [1000, 1000, 1000]})"),
     ": /objects/0: brings the scene to 1000000000 particles, the limit is 1000000; raise /diameter, or make it "
     "smaller or fewer"},
    {"TooManyCopies", OBJECT(R"("type": "joined", "repeat": {"counts": [100, 100, 5]})"),
     ": /objects/0: brings the scene to 2700000 particles, the limit is 1000000; raise /diameter, or make it smaller "
     "or fewer"},
    {"NegativeDensity", WITH(R"("materials": {"sand": {"density": -1600}})"),
     ": /materials/sand/density: -1600 must be above 0 [kg/m3]"},
    {"RestitutionAboveOne", WITH(R"("materials": {"rubber": {"restitution": 1.1}})"),
     ": /materials/rubber/restitution: 1.1 is above the maximum 1"},
    {"NegativeSleep", WITH(R"("solver": {"sleep": -0.1})"), ": /solver/sleep: -0.1 is below the minimum 0 [m/s]"},
    {"NegativeMassScaling", WITH(R"("solver": {"massScaling": -1})"),
     ": /solver/massScaling: -1 is below the minimum 0 [1/m]"},
    {"GrainsTooNear", OBJECT(R"("type": "grains", "shape": "box", "spacing": 0.09)"),
     ": /objects/0/spacing: 0.09 m is below the diameter, 0.1 m, so that grains would overlap; raise it, lower "
     "/diameter, or give 0 for one diameter"},
    {"GrainsInATorus", OBJECT(R"("type": "grains", "shape": "torus")"),
     ": /objects/0/shape: \"torus\" is unknown; known: box, sphere, capsule, cone, mesh"},
    {"TooManyGrains", OBJECT(R"("type": "grains", "shape": "cone", "radius": 20, "height": 20)"),
     ": /objects/0: brings the scene to 8377580 particles, the limit is 1000000; raise /diameter, or make it smaller "
     "or fewer"},
    {"FluidOfASolid", OBJECT(R"("type": "fluid", "shape": "box", "material": "default")"),
     ": /objects/0/material: \"default\" is not a fluid; give that material \"fluid\": true, or take another"},
    {"SolidOfAFluid", OBJECT(R"("type": "rigid", "shape": "box", "material": "water")"),
     ": /objects/0/material: \"water\" is a fluid; only objects of type \"fluid\" are made of fluids"},
    {"FluidTooWide", WITH(R"("fluidSpacing": 1.2)"), ": /fluidSpacing: 1.2 is above the maximum 0.6 [diameters]"},
    {"TooMuchFluid", OBJECT(R"("type": "fluid", "shape": "box", "size": [10, 10, 10])"),
     ": /objects/0: brings the scene to 8000000 particles, the limit is 1000000; raise /diameter, or make it smaller "
     "or fewer"},
    {"EmptyObjectsAndEmitters", R"({"objects": [], "emitters": []})",
     ": /objects: is an array of 0, must be at least 1"},
    {"EmitterWithoutShape", EMITTER(R"("speed": 1)"), ": /emitters/0: \"shape\" is missing; known: disc, rectangle"},
    {"EmitterOfASolid", EMITTER(R"("shape": "disc", "material": "default")"),
     ": /emitters/0/material: \"default\" is not a fluid; give that material \"fluid\": true, or take another"},
    {"EmitterOfNothing", EMITTER(R"("shape": "disc", "material": "watr")"),
     ": /emitters/0/material: there is no material \"watr\"; did you mean \"water\"?"},
    {"EmitterWithoutSpeed", EMITTER(R"("shape": "disc", "speed": 0)"), ": /emitters/0/speed: 0 must be above 0 [m/s]"},
    {"EmitterBackwards", EMITTER(R"("shape": "disc", "speed": -2)"), ": /emitters/0/speed: -2 must be above 0 [m/s]"},
    {"EmitterTooFast", EMITTER(R"("shape": "disc", "speed": 300)"),
     ": /emitters/0/speed: 300 m/s is above /solver/maxSpeed, 100 m/s; lower it or raise the other"},
    {"EmitterWithoutDirection", EMITTER(R"("shape": "disc", "direction": [0, 0, 0])"),
     ": /emitters/0/direction: must not be zero"},
    {"EmitterTooSmall", EMITTER(R"("shape": "disc", "radius": 0.01)"),
     ": /emitters/0/radius: a particle takes 0.05 m, which is too wide for it; make it larger, or lower /fluidSpacing "
     "or /diameter"},
    {"EmitterTooNarrow", EMITTER(R"("shape": "rectangle", "size": [1, 0.02])"),
     ": /emitters/0/size: a particle takes 0.05 m, which is too wide for it; make it larger, or lower /fluidSpacing "
     "or /diameter"},
    {"EmitterTooLarge", EMITTER(R"("shape": "rectangle", "size": [80, 80])"),
     ": /emitters/0: brings the scene to 2560000 particles, the limit is 1000000; make the nozzle smaller"},
    {"EmitterStopsBeforeItStarts", EMITTER(R"("shape": "disc", "start": 2, "stop": 1)"),
     ": /emitters/0/stop: 1 s is before start, 2 s; raise it or lower the other"},
    {"PoolBelowALayer", EMITTER(R"("shape": "rectangle", "size": [0.3, 0.2], "pool": 23)"),
     ": /emitters/0/pool: 23 particles are fewer than the 24 of a layer; raise it, or make the nozzle smaller"},
    {"TooMuchFlow", EMITTER(R"("shape": "rectangle", "size": [4, 4], "speed": 10)"),
     ": /emitters/0/pool: brings the scene to 6400000 particles, the limit is 1000000; give a smaller pool, with "
     "drains "
     "or with whenEmpty \"oldest\""},
    {"EmitterAgainstAFloor",
     R"({ "colliders": [{"type": "sphere", "position": [5, 0, 0]}, {"type": "container", "width": 2, "depth": 2}],
          "emitters": [{"shape": "disc", "position": [0, 0.01, 0], "direction": [0, 1, 0]}] })",
     ": /emitters/0/position: the nozzle is inside or against /colliders/1; keep it at least half a rest distance, "
     "0.025 m, away"},
    {"EmitterInABody",
     R"({ "objects": [{"type": "rigid", "shape": "box", "name": "crate"}], "emitters": [{"shape": "disc"}] })",
     ": /emitters/0/position: the nozzle is inside or against \"crate\"; keep it at least half a rest distance, "
     "0.025 m, away"},
    {"EmitterIntoAWall",
     R"({ "colliders": [{"type": "plane"}], "emitters": [{"shape": "disc", "position": [0, 0.06, 0]}] })",
     ": /emitters/0/direction: leads into /colliders/0 within 0.05 m; turn it away, or move the nozzle back"},
    {"EmitterThroughAWall",
     R"({ "colliders": [{"type": "box", "size": [1, 0.1, 1]}],
          "emitters": [{"shape": "disc", "position": [0, 0.5, 0], "speed": 60}] })",
     ": /emitters/0/direction: leads into /colliders/0 within 0.45 m; turn it away, or move the nozzle back"},
    {"EmitterInADrain",
     R"({ "drains": [{"shape": "plane", "position": [0, -3, 0]}, {"shape": "sphere", "radius": 1}],
          "emitters": [{"shape": "disc"}] })",
     ": /emitters/0/position: the nozzle is inside /drains/1; move one of them"},
    {"DrainOfAnUnknownShape", R"({ "drains": [{"shape": "cone"}], "emitters": [{"shape": "disc"}] })",
     ": /drains/0/shape: \"cone\" is unknown; known: box, sphere, capsule, plane"},
    {"PaperWithEmitter", R"({ "solver": "paper", "emitters": [{"shape": "disc"}] })",
     ": the paper's solver has no fluids; use solver \"impulse\""},
    {"FollowGrains", R"({"objects": [{"type": "grains", "shape": "box"}], "camera": {"kind": "follow"}})",
     ": /camera/kind: \"follow\" needs an object with a body; take \"fixed\""},
    {"HeightfieldOfNothing", WITH(R"("colliders": [{"type": "heightfield", "size": [1, 1]}])"),
     ": /colliders/0: needs either `file` with an image or `heights`, and not both"},
    {"HeightfieldOfUnequalRows",
     WITH(R"("colliders": [{"type": "heightfield", "size": [1, 1], "heights": [[0, 1], [0, 1, 2]]}])"),
     ": /colliders/0/heights/1: has 3 heights, the first row has 2; give all as many"},
    {"HeightfieldOfOneRow", WITH(R"("colliders": [{"type": "heightfield", "size": [1, 1], "heights": [[0, 1]]}])"),
     ": /colliders/0: has 2 x 1 heights; must be at least 2 x 2 and at most 4000000 in all"},
    {"TwinKeys", WITH(R"("fps": 30, "fps": 60)"), ": the key \"fps\" stands twice in one object; remove one of them"},
};

class SceneErrors : public testing::TestWithParam<BadScene> {};

std::string messageOf(const std::string& path, const std::vector<Override>& overrides = {})
{
    try {
        loadScene(path, overrides);
    } catch (const InputError& error) {
        return error.what();
    }
    return "no error";
}

TEST_P(SceneErrors, AreToldInOneLine)
{
    const test::TempFolder folder;
    const std::string path = folder.write("scene.json", GetParam().text);
    const std::string message = messageOf(path);
    EXPECT_EQ(message, path + GetParam().message);
    EXPECT_EQ(message.find('\n'), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(All, SceneErrors, testing::ValuesIn(BAD_SCENES),
                         [](const auto& entry) { return std::string(entry.param.name); });

TEST(SceneFileErrors, TellLineAndColumnOfASyntaxError)
{
    const test::TempFolder folder;
    const std::string path = folder.write("scene.json", "// a comment\n{\n  \"fps\": 60,,\n}\n");
    EXPECT_TRUE(messageOf(path).starts_with(path + ":3:13: syntax error")) << messageOf(path);
    const std::string empty = folder.write("empty.json", "");
    EXPECT_TRUE(messageOf(empty).starts_with(empty + ":1:1: ")) << messageOf(empty);
}

TEST(SceneFileErrors, TellNumbersTooLargeToStore)
{
    const test::TempFolder folder;
    const std::string path = folder.write("scene.json", WITH(R"("fps": 1e999)"));
    EXPECT_TRUE(messageOf(path).starts_with(path + ": number overflow parsing '1e999'")) << messageOf(path);
}

TEST(SceneFileErrors, TellMissingFiles)
{
    const test::TempFolder folder;
    EXPECT_EQ(messageOf(folder.path("none.json")), folder.path("none.json") + ": there is no such file");
    EXPECT_EQ(messageOf(folder.path()), folder.path() + ": is a folder, not a file");
    const std::string path = folder.write("scene.json", OBJECT(R"("type": "actor", "file": "none.glb")"));
    EXPECT_EQ(messageOf(path), path + ": /objects/0/file: there is no file " + folder.path("none.glb") +
                                   "; paths are relative to the scene");
}

TEST(SceneFileErrors, TellWhatIsWrongWithTheFilesOfColliders)
{
    const test::TempFolder folder;
    const auto message = [&](const std::string& collider) {
        return messageOf(
            folder.write("scene.json",
                         R"({ "objects": [{ "type": "rigid", "shape": "box" }], "colliders": [{)" + collider + "}] }"));
    };
    const std::string place = folder.path("scene.json") + ": /colliders/0";
    EXPECT_EQ(message(R"("type": "mesh", "file": "none.obj")"),
              place + "/file: there is no file " + folder.path("none.obj") + "; paths are relative to the scene");
    folder.write("ground.png", "not an image");
    EXPECT_EQ(message(R"("type": "heightfield", "file": "ground.png", "size": [1, 1])"),
              place + "/file: image " + folder.path("ground.png") +
                  " cannot be read: Image not of any known type, or corrupt; PNG and JPEG are known");
    folder.write("sheet.obj", "v 0 0 0\nv 1 0 0\nv 0 0 1\nf 1 2 3\n");
    EXPECT_EQ(message(R"("type": "mesh", "file": "sheet.obj", "scale": 1)"),
              place +
                  ": the mesh encloses no volume that cells of 0.1 m see; close it, lower `cell`, or give a sheet a "
                  "`thickness`");
    folder.write("nan.obj", "v nan 0 0\nv 1 0 0\nv 0 0 1\nf 1 2 3\n");
    EXPECT_TRUE(message(R"("type": "mesh", "file": "nan.obj")").starts_with(place + ": "));
}

TEST(SceneFileErrors, ComeBeforeAnythingLargeIsMade)
{
    const test::TempFolder folder;
    const std::string path = folder.write("scene.json",
                                          OBJECT(R"("type": "joined", "bodies": 10000, "size": [1000, 1000, 1000])"));
    EXPECT_NE(messageOf(path).find("10000000000000 particles"), std::string::npos) << messageOf(path);
}

TEST(OverrideErrors, NameTheOption)
{
    const test::TempFolder folder;
    const std::string path = folder.write("scene.json", WITH(R"("fps": 60)"));
    EXPECT_EQ(messageOf(path, {{"objects.3.size", 1}}),
              "--set objects.3.size: \"3\" is not one of the list's 1 places; they count from 0");
    EXPECT_EQ(messageOf(path, {{"fps.x", 1}}), "--set fps.x: there is nothing below \"x\" to set");
    EXPECT_EQ(messageOf(path, {{"a..b", 1}}), "--set a..b: a part of the path is empty");
    EXPECT_THROW(parseOverride("fps"), InputError);
    EXPECT_THROW(parseOverride("=3"), InputError);
}

}  // namespace
}  // namespace knuckle
