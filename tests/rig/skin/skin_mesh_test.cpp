#include "sim/rig/skin/skin_mesh.h"

#include "sim/base/errors.h"
#include "tests/message_of.h"
#include "tests/rig/actor_fixture.h"

namespace knuckle {
namespace {

/// Bones with these names in a row, each the child of the one before.
Model chainOf(const std::vector<std::string>& names)
{
    Model model;
    model.name = "chain";
    for (const std::string& name : names) model.bones.push_back({name, static_cast<int32_t>(model.bones.size()) - 1});
    model.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    model.triangles = {{0, 1, 2}};
    model.skin.resize(3);
    for (SkinWeights& skin : model.skin) skin.weights[0] = 1.0f;
    model.surface.vertices.resize(3);
    model.surface.materials.resize(1);
    return model;
}

Actor bodiesOf(const std::vector<ActorBody>& bodies)
{
    Actor actor;
    actor.name = "doll";
    actor.bodies = bodies;
    return actor;
}

TEST(SkinMesh, BonesGoToTheBodyThatTookThemOrToTheNearest)
{
    const Model model = chainOf({"root", "hips", "spine", "neck", "hat"});
    const Actor actor = bodiesOf({{"hips", {}, -1, {}}, {"hips/cross", {}, 0, {}, true}, {"spine", {}, 1, {"neck"}}});
    EXPECT_EQ(bodiesOfBones(actor, model), (std::vector<uint32_t>{0, 0, 2, 2, 2}));
}

TEST(SkinMesh, AVertexHasTheFourBodiesThatWeighMost)
{
    Model model = chainOf({"a", "b", "b tip", "c", "d", "e"});
    model.skin[0].bones = {0, 1, 2, 3, 4, 5};
    model.skin[0].weights = {0.05f, 0.15f, 0.15f, 0.3f, 0.25f, 0.1f};
    const Actor actor = bodiesOf(
        {{"a", {}, -1, {}}, {"b", {}, 0, {"b tip"}}, {"c", {}, 1, {}}, {"d", {}, 2, {}}, {"e", {}, 3, {}}});
    const SkinVertex vertex = makeSkinMesh(actor, model).vertices[0];
    EXPECT_EQ(vertex.bodies, (std::array<uint32_t, 4>{1, 2, 3, 4}));
    for (const auto& [i, share] : {std::pair{0, 0.3f}, {1, 0.3f}, {2, 0.25f}, {3, 0.1f}})
        EXPECT_NEAR(vertex.weights[i], share / 0.95f, 1e-6f);
}

TEST(SkinMesh, AModelOfOneBodyIsWornWhole)
{
    Model model = twoBoneBox("top");
    model.bones.clear();
    model.skin.clear();
    model.surface.vertices.resize(model.vertices.size());
    model.surface.materials.resize(1);
    const SkinMesh mesh = makeSkinMesh(make(model, 0.1f), model);
    ASSERT_EQ(mesh.vertices.size(), model.vertices.size());
    EXPECT_EQ(mesh.triangles, model.triangles);
    EXPECT_EQ(mesh.vertices[3].bodies[0], 0u);
    EXPECT_EQ(mesh.vertices[3].weights[0], 1.0f);
}

TEST(SkinMesh, RefusesAModelWithoutAMeshAndAnother)
{
    Model model = chainOf({"root", "tip"});
    const Actor actor = bodiesOf({{"hips", {}, -1, {}}, {"leg", {}, 0, {}}});
    EXPECT_EQ(test::messageOf<InputError>([&] { makeSkinMesh(actor, model); }),
              "no body of the actor 'doll' is a bone of the model 'chain': make the actor anew of it with knuckle "
              "voxelize");
    model.surface.vertices.clear();
    EXPECT_EQ(test::messageOf<InputError>([&] { makeSkinMesh(actor, model); }),
              "the model 'chain' has no mesh to draw: give one that has");
}

}  // namespace
}  // namespace knuckle
