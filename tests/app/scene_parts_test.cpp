#include <set>

#include "tests/app/one_object_scene.h"

namespace knuckle::test {
namespace {

/// Two boxes of 0.4 m, 0.2 m apart along x.
std::string twoBoxes()
{
    std::string text;
    for (const float x : {0.0f, 0.6f}) {
        for (int i = 0; i < 8; ++i)
            text += "v " + std::to_string(x + (i & 1 ? 0.4f : 0.0f)) + (i & 2 ? " 0.4" : " 0") +
                    (i & 4 ? " 0.4\n" : " 0\n");
        text += "f -8 -6 -5 -7\nf -4 -3 -1 -2\nf -8 -7 -3 -4\nf -6 -2 -1 -5\nf -8 -4 -2 -6\nf -7 -5 -1 -3\n";
    }
    return text;
}

std::string sceneOf(const std::string& object)
{
    return R"({ "diameter": 0.05, "objects": [{ "type": "actor", )" + object + " }] }";
}

class SceneParts : public testing::Test {
protected:
    SceneParts() { folder.write("boxes.obj", twoBoxes()); }
    World world(const std::string& object) const
    {
        return loadScene(folder.write("scene.json", sceneOf(object))).world;
    }
    std::string complaint(const std::string& object) const
    {
        const std::string message = messageOf<InputError>([&] { world(object); });
        const size_t end = message.find("scene.json: ");
        return end == std::string::npos ? message : message.substr(end + 12);
    }
    TempFolder folder;
};

TEST_F(SceneParts, AreBodiesThatNothingJoinsAndTheMeshFollowsThem)
{
    EXPECT_EQ(world(R"("file": "boxes.obj")").bodies.size(), 1u);
    const World split = world(R"("file": "boxes.obj", "split": true)");
    ASSERT_EQ(split.bodies.size(), 2u);
    EXPECT_TRUE(split.joints.empty());
    EXPECT_NE(split.bodies[0].assembly, split.bodies[1].assembly);
    ASSERT_EQ(split.skins.size(), 1u);
    std::set<uint32_t> bodies;
    for (const SkinVertex& vertex : split.skins[0].mesh->vertices) {
        EXPECT_EQ(vertex.bodies[0], vertex.position.x() > 0.5f ? 1u : 0u);
        EXPECT_EQ(vertex.weights[0], 1.0f);
        bodies.insert(vertex.bodies[0]);
    }
    EXPECT_EQ(bodies.size(), 2u);
}

TEST_F(SceneParts, HaveNoJointsToDescribe)
{
    folder.write("joints.json", "{}");
    EXPECT_EQ(complaint(R"("file": "boxes.obj", "split": true, "joints": "joints.json")"),
              "/objects/0/joints: parts have none; take this or `split` away");
    EXPECT_NE(
        complaint(R"("file": ")" + inSource("assets/models/dog.glb") + R"(", "split": true)").find("leave `split`"),
        std::string::npos);
}

}  // namespace
}  // namespace knuckle::test
