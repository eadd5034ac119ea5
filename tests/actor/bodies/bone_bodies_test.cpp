#include "tests/actor/actor_fixture.h"

namespace knuckle {
namespace {

TEST(BodiesOfBones, boneTooSmallForABodyMergesIntoItsParentAndIsNoted)
{
    Model model = twoBoneBox("tip", 0.02f);  // a rod: one row of particles, all on one line
    model.bones.push_back({"root2", -1});
    Model body = twoBoneBox("unused");
    for (size_t v = 0; v < 8; ++v) {  // a solid root so that there is a body at all
        model.vertices.push_back(body.vertices[v] + Vector3f(0, 0, -1));
        model.skin.push_back(body.skin[v]);
    }
    for (size_t t = 0; t < 12; ++t) {
        const auto& triangle = body.triangles[t];
        model.triangles.push_back({triangle[0] + 16, triangle[1] + 16, triangle[2] + 16});
    }
    const Actor actor = make(model, 0.1f);
    ASSERT_EQ(actor.bodies.size(), 1u);
    EXPECT_EQ(actor.bodies[0].mergedBones, std::vector<std::string>{"tip"});
    EXPECT_TRUE(std::any_of(actor.notes.begin(), actor.notes.end(),
                            [](const std::string& note) { return note.find("tip") != std::string::npos; }));
}

TEST(BodiesOfBones, smallBoneMergesIntoItsParentEvenWhereAnotherBodyIsNearer)
{
    Model model = twoBoneBox("other");
    const TriangleMesh rod = boxMesh({0, 0, 2.4f}, {0.02f, 0.02f, 0.2f});
    for (const Triangle& t : rod.triangles) {
        model.triangles.push_back({t[0] + 16, t[1] + 16, t[2] + 16});
    }
    for (const Vector3f& v : rod.vertices) {
        model.vertices.push_back(v);
        model.skin.push_back({{2}, {1.0f}});
    }
    model.bones.push_back({"rod", 0});
    const Actor actor = make(model, 0.1f);
    ASSERT_EQ(actor.bodies.size(), 2u);
    EXPECT_EQ(actor.bodies[0].name, "root");
    EXPECT_EQ(actor.bodies[0].mergedBones, std::vector<std::string>{"rod"});
}

TEST(BodiesOfBones, partsThatDoNotTouchAreBridgedAtTheJoint)
{
    Model model = twoBoneBox("tip");
    for (size_t v = 8; v < 16; ++v) {
        model.vertices[v].z() += 0.4f;  // four diameters of air
    }
    model.bones[1].restPose(2, 3) = 1.2f;
    const Actor actor = make(model, 0.1f);
    expectSound(actor);
    EXPECT_EQ(actor.joints.size(), 1u);
}

TEST(BodiesOfBones, secondRootJoinsTheNearestBody)
{
    Model model = twoBoneBox("tip");
    model.bones[1].parent = -1;
    const Actor actor = make(model, 0.1f);
    expectSound(actor);
    EXPECT_EQ(actor.joints.size(), 1u);
}

TEST(BodiesOfBones, modelWithoutBonesIsOneRigidBody)
{
    Model model;
    model.name = "ball";
    const TriangleMesh mesh = sphereMesh(0.5f);
    model.vertices = mesh.vertices;
    model.triangles = mesh.triangles;
    const Actor actor = make(model, 0.1f);
    ASSERT_EQ(actor.bodies.size(), 1u);
    EXPECT_EQ(actor.bodies[0].name, "ball");
    EXPECT_EQ(actor.bodies[0].particles.size(), actor.particles.size());
    EXPECT_TRUE(actor.joints.empty());
}

}  // namespace
}  // namespace knuckle
