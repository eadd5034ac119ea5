#include "app/files/actor_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <numbers>
#include <random>

#include "app/commands/voxelize/actor_table.h"
#include "app/files/actor_check.h"
#include "app/files/joints_file.h"
#include "app/scene/scene_file.h"
#include "sim/base/errors.h"
#include "sim/rig/bodies/make_actor.h"
#include "sim/rig/import/import.h"
#include "sim/world/fingerprint/fingerprint.h"
#include "tests/places.h"
#include "tests/temp_folder.h"

namespace knuckle {
namespace {

/// Two bodies with one particle in common, at 2000 random positions, apart along x, whose text must give the same bits.
Actor makePair()
{
    Actor actor;
    actor.name = "pa\"ir\\";
    actor.diameter = 0.1f / 3.0f;
    std::mt19937 random(1);
    std::uniform_real_distribution<float> any(0.0f, 0.5f);
    for (int i = 0; i < 2000; ++i) {
        const auto number = [&] {
            const auto mantissa = static_cast<float>(random());
            return std::ldexp(mantissa, static_cast<int>(random() % 60) - 80);
        };
        actor.particles.emplace_back(actor.diameter * (static_cast<float>(i) + any(random)), -number(), number());
        actor.signedDistances.push_back(-number());
        actor.outward.push_back(i % 3 == 0 ? Vector3f(0, 0, 0) : Vector3f(number() + 1e-9f, 1, -number()).normalized());
    }
    actor.particles[5].z() = -0.0f;
    actor.signedDistances[6] = -0.0f;
    actor.bodies = {{"hip", {}, -1, {"pelvis", "belly"}}, {"leg", {}, 0, {"knee", "shin", "toe"}}};
    for (uint32_t i = 0; i < 2000; ++i) actor.bodies[i < 1200 ? 0 : 1].particles.push_back(i);
    actor.bodies[1].particles.push_back(7);
    actor.joints = {{"leg", JointType::Hinge, 0, 1, {0.1f, -0.2f, 1e-7f}, {0, 1, 0}, {7}}};
    actor.joints[0].limits.bend = {-0.5f, std::numbers::pi_v<float> / 2};
    actor.joints[0].limits.stiffness = 12.5f;
    actor.joints[0].strength.force = 2500.0f;
    actor.filtered = {{0, 1}};
    actor.notes = {"pelvis has 2 particles and became part of hip"};
    return actor;
}

bool sameBits(const Vector3f& a, const Vector3f& b)
{
    return std::ranges::equal(a, b, {}, std::bit_cast<uint32_t, float>, std::bit_cast<uint32_t, float>);
}

TEST(ActorFile, ReadsBackExactlyWhatWasWritten)
{
    const test::TempFolder folder;
    const Actor actor = makePair();
    writeActor(folder.path("actor.json"), actor);
    const Actor back = readActor(folder.path("actor.json"));
    EXPECT_EQ(back.name, actor.name);
    EXPECT_EQ(back.diameter, actor.diameter);
    EXPECT_EQ(back.signedDistances, actor.signedDistances);
    EXPECT_EQ(back.outward, actor.outward);
    EXPECT_EQ(back.notes, actor.notes);
    ASSERT_EQ(back.particles.size(), actor.particles.size());
    for (size_t i = 0; i < actor.particles.size(); ++i) EXPECT_TRUE(sameBits(back.particles[i], actor.particles[i]));
    ASSERT_EQ(back.bodies.size(), 2u);
    EXPECT_EQ(back.bodies[0].mergedBones, actor.bodies[0].mergedBones);
    EXPECT_EQ(back.bodies[1].particles, actor.bodies[1].particles);
    EXPECT_EQ(back.bodies[1].parent, 0);
    ASSERT_EQ(back.joints.size(), 1u);
    EXPECT_EQ(back.joints[0].type, JointType::Hinge);
    EXPECT_TRUE(sameBits(back.joints[0].anchor, actor.joints[0].anchor));
    EXPECT_TRUE(sameBits(back.joints[0].axis, actor.joints[0].axis));
    EXPECT_EQ(back.joints[0].sharedParticles, actor.joints[0].sharedParticles);
    EXPECT_NEAR(back.joints[0].limits.bend.lowest, -0.5f, 1e-6f);
    EXPECT_NEAR(back.joints[0].limits.bend.highest, std::numbers::pi / 2, 1e-6);
    EXPECT_EQ(back.joints[0].limits.stiffness, 12.5f);
    EXPECT_FALSE(back.joints[0].limits.twist.bounded());
    EXPECT_EQ(back.joints[0].strength.force, 2500.0f);
    EXPECT_TRUE(std::isinf(back.joints[0].strength.torque));
    EXPECT_EQ(back.filtered, actor.filtered);
    EXPECT_TRUE(std::signbit(back.signedDistances[6]));
    EXPECT_EQ(actorText(back), actorText(actor));
}

TEST(ActorFile, MakesTheWorldThatItsModelMakes)
{
    const test::TempFolder folder;
    const Actor actor = makeActor(importModel(test::inSource("assets/models/dog.glb")), {});
    ASSERT_FALSE(actor.filtered.empty()) << "its forelegs pass through its chest";
    const uint64_t expected = fingerprint(worldOf("model", actor));
    for (const char* file : {"dog.json", "dog.npz"}) {
        writeActor(folder.path(file), actor);
        EXPECT_EQ(fingerprint(worldOf(file, readActor(folder.path(file)))), expected) << file;
    }
    Actor touching = actor;
    touching.filtered.clear();
    EXPECT_NE(fingerprint(worldOf("touching", touching)), expected);
}

TEST(ActorFile, IsTheSameAsArrays)
{
    const test::TempFolder folder;
    Actor actor = makePair();
    actor.name = "Füchsin 狐 🦊";
    actor.bodies[1].mergedBones = {};
    actor.model.file = folder.path("fox.glb");
    actor.model.fit.up = UpAxis::Z;
    actor.model.pick.skeleton = "hips*";
    actor.skin.vertices = {{0, 1, 2}, {3, 4, 5}, {6, 7, -0.0f}};
    actor.skin.triangles = {{0, 1, 2}};
    actor.skin.ofVertices = {{{1, 0, 0, 0}, {0.75f, 0.25f, 0, 0}}, {}, {}};
    for (const Vector3f& particle : actor.particles)
        actor.skin.ofParticles.push_back({{particle.x() > 0.1f, 0, 0, 0}, {1, 0, 0, 0}});
    writeActor(folder.path("actor.npz"), actor);
    const Actor back = readActor(folder.path("actor.npz"));
    EXPECT_EQ(back.model.file, actor.model.file);
    EXPECT_EQ(actorText(back), actorText(actor));
    EXPECT_TRUE(isActorFile(folder.path("actor.npz")));
}

TEST(ActorFile, AnActorWithoutJointsIsTheSameAsArrays)
{
    const test::TempFolder folder;
    Actor actor;
    actor.diameter = 0.1f;
    for (int i = 0; i < 3; ++i) actor.particles.emplace_back(0.1f * static_cast<float>(i), 0.0f, 0.0f);
    actor.bodies = {{"rod", {0, 1, 2}, -1, {}}};
    writeActor(folder.path("actor.npz"), actor);
    EXPECT_EQ(actorText(readActor(folder.path("actor.npz"))), actorText(actor));
}

std::string messageOf(const test::TempFolder& folder, const std::string& from, const std::string& to)
{
    std::string text = R"({ "format": "knuckle-actor", "version": 1, "diameter": 0.1,
        "particles": [[0, 0, 0], [0.1, 0, 0]],
        "bodies": [{ "name": "a", "particles": [0, 1] }, { "name": "b", "parent": 0, "particles": [1] }],
        "joints": [{ "name": "b", "type": "ball", "parent": 0, "child": 1, "sharedParticles": [1] }] })";
    const size_t at = text.find(from);
    if (at != std::string::npos) text.replace(at, from.size(), to);
    const std::string path = folder.write("actor.json", text);
    try {
        readActor(path);
    } catch (const InputError& error) {
        return std::string(error.what()).substr(path.size());
    }
    return "fine";
}

TEST(ActorFile, TellsWhatIsWrong)
{
    const test::TempFolder folder;
    EXPECT_EQ(messageOf(folder, "knuckle", "knuckle"), "fine");
    EXPECT_EQ(messageOf(folder, "knuckle-actor", "gltf"), ": /format: \"gltf\" is unknown; known: knuckle-actor");
    EXPECT_EQ(messageOf(folder, "\"version\": 1", "\"version\": 2"), ": /version: 2 is above the maximum 1");
    EXPECT_EQ(messageOf(folder, "[0, 1] }", "[0, 5] }"), ": /bodies/0/particles/1: 5 is not one of the 2 particles");
    EXPECT_EQ(messageOf(folder, "\"child\": 1", "\"child\": 4"), ": /joints/0/child: 4 is not one of the 2 bodies");
    EXPECT_EQ(messageOf(folder, "\"parent\": 0, \"particles\"", "\"parent\": 1, \"particles\""),
              ": /bodies/1/parent: 1 must be smaller than the body's own place, 1");
    EXPECT_EQ(messageOf(folder, "\"name\": \"a\",", "\"name\": \"a\", \"mass\": 2.5,"),
              ": /bodies/0/mass: has 2.5, but by its particles 1.5 at 1000 kg/m3; correct it, or leave it out");
    EXPECT_EQ(messageOf(folder, "\"name\": \"a\",", "\"name\": \"a\", \"centre\": [0, 0, 0],"),
              ": /bodies/0/centre: has 0, but by its particles 0.03333 at 1000 kg/m3; correct it, or leave it out");
    EXPECT_EQ(messageOf(folder, "\"joints\"", "\"skin\": { \"vertices\": [[0, 0, 0]] }, \"joints\""),
              ": /skin/bodies: has 0 entries for 1 vertices; give one each");
    EXPECT_EQ(messageOf(folder, "[0, 1] }", "[1] }"), ": /particles/0: belongs to no body; remove it");
}

TEST(ActorFile, MustHaveTheScenesDiameter)
{
    const test::TempFolder folder;
    messageOf(folder, "", "");
    const std::string scene = folder.write("scene.json", R"({ "diameter": 0.05,
        "objects": [{ "type": "actor", "file": "actor.json" }] })");
    try {
        loadScene(scene);
        FAIL() << "no error";
    } catch (const InputError& error) {
        EXPECT_EQ(error.what(), scene + ": /objects/0/file: " + folder.path("actor.json") +
                                    " is made of particles of 0.1 m, the scene of 0.05 m; set /diameter to 0.1, or "
                                    "make the actor with knuckle voxelize --diameter 0.05");
    }
}

TEST(ActorFile, StandsInASceneAsOftenAsItIsRepeated)
{
    const test::TempFolder folder;
    messageOf(folder, "", "");
    const Scene scene = loadScene(folder.write("scene.json", R"({
        "objects": [{ "type": "actor", "name": "doll", "file": "actor.json", "repeat": { "counts": [3, 1, 1] } }] })"));
    ASSERT_EQ(scene.world.objects.size(), 3u);
    EXPECT_EQ(scene.world.objects[2].name, "doll_3");
    EXPECT_EQ(scene.world.particles.size(), 6u);
    EXPECT_EQ(scene.world.bodies.size(), 6u);
}

TEST(JointsFile, GivesTypesAndAxes)
{
    const test::TempFolder folder;
    ArticulationOptions options;
    readJoints(folder.write("joints.json", R"({ "Knee": "hinge", "Tail": { "type": "universal", "axis": [0, 0.5, 0] },
        "Neck": { "axis": [1, 0, 0] } // the type as it is
        })"),
               options);
    EXPECT_EQ(options.types,
              (std::map<std::string, JointType>{{"Knee", JointType::Hinge}, {"Tail", JointType::Universal}}));
    EXPECT_EQ(options.axes.at("Tail"), Vector3f(0, 1, 0));
    EXPECT_EQ(options.axes.at("Neck"), Vector3f(1, 0, 0));
}

TEST(JointsFile, TellsWhatIsWrong)
{
    const test::TempFolder folder;
    const auto message = [&](const std::string& text) {
        const std::string path = folder.write("joints.json", text);
        ArticulationOptions options;
        try {
            readJoints(path, options);
        } catch (const InputError& error) {
            return std::string(error.what()).substr(path.size());
        }
        return std::string("fine");
    };
    EXPECT_EQ(message(R"({ "Knee": "hing" })"), ": /Knee: \"hing\" is unknown; did you mean \"hinge\"?");
    EXPECT_EQ(message(R"({ "Knee": 3 })"), ": /Knee: is 3 (a number), must be a string or an object");
    EXPECT_EQ(message(R"({ "Knee": { "axis": [0, 0, 0] } })"), ": /Knee/axis: must not be zero");
}

TEST(ActorTable, TellsBodiesJointsAndWhatWasMerged)
{
    Actor actor = makePair();
    actor.joints[0].axis = {0.6f, 0, -0.8f};
    Model model;
    model.vertices = {{-1, 0.25f, 0}, {1, 2, 0.5f}};
    model.bones = {{"hip", -1}, {"pelvis", 0}, {"leg", 0}};
    model.clips = {{"run", 1.5, {}, {}}};
    model.unusableClips = {{"jump", "has keys that are not numbers"}};
    model.poseFrom = "clip 'run' at 0.50 s";
    model.surface.notes = {"The texture is not there."};
    ArticulationOptions options;
    options.merge = {"pelvis"};
    options.limits["l*g"] = {};
    EXPECT_EQ(actorTable(actor, readFigure(model), options, {1.014, 0.25}),
              "body  parent  particles  joint  shared  turns, degrees                                          "
              "taken for (by)\n"
              "hip   -            1200  -           -  -                                                       "
              "hips (name)\n"
              "leg   hip           801  hinge       1  -29 to 90 about (0.60 0.00 -0.80), spring 12.5 N m/rad  "
              "thigh (name, --joints)\n"
              "\n"
              "pa\"ir\\: 2000 particles of 0.033333335 m, 2 bodies, 1 joint, 5 bones merged\n"
              "size: 2 m wide, 1.75 high, 0.5 deep; its lowest point at a height of 0.25 m\n"
              "fill: 101 % of the mesh's volume; its surface is 0.25 diameters off the particles'\n"
              "pose: clip 'run' at 0.50 s\n"
              "clip: run, 1.50 s\n"
              "clip: jump has keys that are not numbers\n"
              "note: pelvis has 2 particles and became part of hip\n"
              "note: The texture is not there.\n");
}

}  // namespace
}  // namespace knuckle
