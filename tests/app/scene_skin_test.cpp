#include "app/files/actor_file.h"
#include "sim/rig/bodies/make_actor.h"
#include "sim/rig/gltf/glb.h"
#include "sim/rig/import/import.h"
#include "sim/world/fingerprint/fingerprint.h"
#include "tests/app/one_object_scene.h"

namespace knuckle::test {
namespace {

/// A cube of side 0.4 m whose material file does not exist, or not yet.
const char* const CUBE = "mtllib cube.mtl\nusemtl paint\nv 0 0 0\nv 0.4 0 0\nv 0 0.4 0\nv 0.4 0.4 0\nv 0 0 0.4\n"
                         "v 0.4 0 0.4\nv 0 0.4 0.4\nv 0.4 0.4 0.4\nf 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\n"
                         "f 1 5 7 3\nf 2 4 8 6\n";

std::string actorOf(const std::string& file, const std::string& skin)
{
    return R"({ "diameter": 0.05, "objects": [{ "type": "actor", "file": ")" + file + R"(", "skin": ")" + skin +
           R"(", "repeat": { "counts": [2, 1, 1] } }] })";
}

/// The error message for a scene of an actor, without the path of the scene.
std::string complaint(const TempFolder& folder, const std::string& file)
{
    const std::string path = folder.write("scene.json", actorOf(file, "mesh"));
    const std::string message = messageOf<InputError>([&] { loadScene(path); });
    return message.starts_with(path + ": ") ? message.substr(path.size() + 2) : message;
}

TEST(SceneSkin, CopiesOfAnActorWearOneMesh)
{
    const TempFolder folder;
    const std::string figure = inSource("assets/models/humanoid.glb");
    EXPECT_TRUE(loadScene(folder.write("scene.json", actorOf(figure, "particles"))).world.skins.empty());
    for (const auto& [kind, use] : {std::pair{"auto", SkinUse::Hide},
                                    {"mesh", SkinUse::Hide},
                                    {"both", SkinUse::Cover},
                                    {"colors", SkinUse::Paint}}) {
        const World world = loadScene(folder.write("scene.json", actorOf(figure, kind))).world;
        ASSERT_EQ(world.skins.size(), 1u);
        EXPECT_EQ(world.skins[0].objects, (std::vector<uint32_t>{0, 1}));
        EXPECT_EQ(world.skins[0].use, use) << kind;
        EXPECT_GT(world.skins[0].mesh->triangles.size(), 1000u);
    }
}

TEST(SceneSkin, ARigidMeshWearsItsOwn)
{
    const World world = worldOf(R"({ "type": "rigid", "shape": "mesh", "file": "FILE", "skin": "mesh" })");
    ASSERT_EQ(world.skins.size(), 1u);
    for (const SkinVertex& vertex : world.skins[0].mesh->vertices) EXPECT_EQ(vertex.weights[0], 1.0f);
}

TEST(SceneSkin, WhatIsNotVisibleWearsNoneAndMovesAlike)
{
    const std::string doll = R"({ "type": "actor", "file": "FILE", "skin": "mesh")";
    const World seen = worldOf(doll + " }"), unseen = worldOf(doll + R"(, "visible": false })");
    EXPECT_TRUE(seen.unseen.empty());
    ASSERT_EQ(unseen.unseen.size(), 1u);
    EXPECT_EQ(unseen.unseen[0].first, 0u);
    EXPECT_EQ(unseen.unseen[0].end, unseen.particles.size());
    EXPECT_TRUE(unseen.skins.empty());
    EXPECT_EQ(fingerprint(unseen), fingerprint(seen));
}

TEST(SceneSkin, ASkinDoesNotChangeWhatMoves)
{
    const World plain = worldOf(R"({ "type": "actor", "file": "FILE", "skin": "particles" })");
    const World skinned = worldOf(R"({ "type": "actor", "file": "FILE", "skin": "mesh" })");
    ASSERT_EQ(skinned.particles.size(), plain.particles.size());
    for (size_t i = 0; i < plain.particles.size(); ++i)
        EXPECT_EQ(skinned.particles[i].position, plain.particles[i].position);
}

TEST(SceneSkin, AnActorFileSaysWhereItsMeshIs)
{
    const TempFolder folder;
    folder.write("cube.obj", CUBE);
    Actor actor = makeActor(importModel(folder.path("cube.obj")),
                            {.name = {}, .voxels = {.diameter = 0.05f}, .articulation = {}});
    writeActor(folder.path("nameless.json"), actor);
    actor.model = {folder.path("cube.obj"), {.scale = 1.0}};
    std::filesystem::create_directory(folder.path("actors"));
    writeActor(folder.path("actors/cube.json"), actor);
    EXPECT_NE(readText(folder.path("actors/cube.json")).find(R"("model": "../cube.obj")"), std::string::npos);
    const Scene scene = loadScene(folder.write("scene.json", actorOf("actors/cube.json", "mesh")));
    ASSERT_EQ(scene.world.skins.size(), 1u);
    EXPECT_EQ(scene.world.skins[0].mesh->triangles.size(), 12u);

    EXPECT_EQ(complaint(folder, "nameless.json"),
              "/objects/0/skin: " + folder.path("nameless.json") +
                  " does not say of which `model` it was made; make it anew with knuckle voxelize, or take "
                  "\"particles\"");
    const Scene bare = loadScene(folder.write("scene.json", actorOf("nameless.json", "auto")));
    EXPECT_TRUE(bare.world.skins.empty());
    EXPECT_TRUE(bare.notes.empty());
    ASSERT_EQ(bare.warnings.size(), 1u);
    EXPECT_TRUE(bare.warnings[0].starts_with("/objects/0: its particles are drawn: ")) << bare.warnings[0];
    std::filesystem::remove(folder.path("cube.obj"));
    EXPECT_EQ(complaint(folder, "actors/cube.json"), "/objects/0/skin: " + folder.path("actors/cube.json") +
                                                         " was made of " + folder.path("cube.obj") +
                                                         ", which is not there; put it there, or take \"particles\"");
}

TEST(SceneSkin, ADamagedModelBehindAnActorFileLeavesItsParticles)
{
    const TempFolder folder;
    folder.write("cube.obj", CUBE);
    Actor actor = makeActor(importModel(folder.path("cube.obj")),
                            {.name = {}, .voxels = {.diameter = 0.05f}, .articulation = {}});
    actor.model = {folder.path("cube.obj"), {}};
    writeActor(folder.path("cube.json"), actor);
    folder.write("cube.obj", "v 0 0\n");
    const Scene scene = loadScene(folder.write("scene.json", actorOf("cube.json", "auto")));
    EXPECT_TRUE(scene.world.skins.empty());
    ASSERT_EQ(scene.warnings.size(), 1u);
    EXPECT_TRUE(scene.warnings[0].starts_with("/objects/0: its particles are drawn: " + folder.path("cube.obj")))
        << scene.warnings[0];
    const std::string wanted = complaint(folder, "cube.json");
    EXPECT_TRUE(wanted.starts_with("/objects/0/skin: " + folder.path("cube.obj"))) << wanted;
    EXPECT_TRUE(wanted.ends_with(", or take \"particles\"")) << wanted;
}

TEST(SceneSkin, OfTwoFiguresInAFileASceneTakesOne)
{
    const TempFolder folder;
    const Model model = importModel(inSource("assets/models/humanoid.glb"), {.clips = false, .surface = true});
    folder.write("pair.glb", toGlb(std::vector{model, model}));
    EXPECT_EQ(complaint(folder, "pair.glb"), "/objects/0/skeleton: " + folder.path("pair.glb") +
                                                 ": it holds 2 skeletons: hips (19 bones), hips#2 (19 bones); give the "
                                                 "name of one, or \"*\" for all as one");
    const World world = loadScene(folder.write("scene.json", R"({ "diameter": 0.1, "objects": [
        { "type": "actor", "file": "pair.glb", "skeleton": "hips" },
        { "type": "actor", "file": "pair.glb", "skeleton": "*", "position": [0, 0, 3] },
        { "type": "rigid", "shape": "mesh", "file": "pair.glb", "position": [0, 0, 6] }] })"))
                            .world;
    ASSERT_EQ(world.skins.size(), 3u);
    EXPECT_EQ(world.skins[0].mesh->triangles.size(), model.triangles.size());
    EXPECT_EQ(world.skins[1].mesh->triangles.size(), 2 * model.triangles.size());
    EXPECT_EQ(world.skins[2].mesh->triangles.size(), 2 * model.triangles.size());
}

TEST(SceneSkin, WhatOfATextureCannotBeHadIsAWarning)
{
    const TempFolder folder;
    folder.write("cube.obj", CUBE);
    folder.write("cube.mtl", "newmtl paint\nmap_Kd paint.png\n");
    const Scene scene = loadScene(folder.write("scene.json", actorOf("cube.obj", "mesh")));
    EXPECT_TRUE(scene.notes.empty());
    ASSERT_EQ(scene.warnings.size(), 1u);
    EXPECT_EQ(scene.warnings[0], "/objects/0/skin: Texture 'paint.png' is not there: drawn plain.");
}

TEST(SceneSkin, ASkeletonAloneHasNone)
{
    const TempFolder folder;
    folder.write("walker.bvh", "HIERARCHY\nROOT Hips\n{\n OFFSET 0 90 0\n CHANNELS 6 Xposition Yposition Zposition "
                               "Zrotation Xrotation Yrotation\n JOINT Chest\n {\n  OFFSET 0 40 0\n  CHANNELS 3 "
                               "Zrotation Xrotation Yrotation\n  End Site\n  {\n   OFFSET 0 40 0\n  }\n }\n}\n"
                               "MOTION\nFrames: 1\nFrame Time: 0.05\n0 90 0 0 0 0 0 0 0\n");
    EXPECT_EQ(complaint(folder, "walker.bvh"),
              "/objects/0/skin: the model 'walker' has no mesh to draw: give one that has, or take \"particles\"");
    const Scene scene = loadScene(folder.write("scene.json", actorOf("walker.bvh", "auto")));
    EXPECT_TRUE(scene.world.skins.empty());
    EXPECT_TRUE(scene.notes.empty());
}

}  // namespace
}  // namespace knuckle::test
