#include "tests/app/one_object_scene.h"

namespace knuckle::test {
namespace {

std::vector<std::string> warningsOf(const std::string& material)
{
    const TempFolder folder;
    const std::string path = folder.write("scene.json", R"({ "diameter": 0.02, "materials": { "gel": {)" + material +
                                                            R"(} }, "objects": [{ "type": "soft", "shape": "box",
        "size": [0.1, 0.1, 0.1], "material": "gel" }] })");
    return loadScene(path, {}).warnings;
}

TEST(SceneSoft, TellsWhatStiffnessAndDampingItsSizeCanShow)
{
    EXPECT_TRUE(warningsOf(R"("stiffness": 80000)").empty());
    EXPECT_TRUE(warningsOf(R"("stiffness": 1000000)").empty());
    const auto stiff = warningsOf(R"("stiffness": 1e9)"), damped = warningsOf(R"("stiffness": 80000, "damping": 1)");
    ASSERT_EQ(stiff.size(), 1u);
    EXPECT_TRUE(stiff[0].starts_with("/materials/gel: soft bodies show a stiffness of ")) << stiff[0];
    EXPECT_TRUE(
        stiff[0].find(" Pa instead of 1e+09 and a damping of 0.0042 s instead of 0.005 at 16 substeps and 0.02 m; "
                      "with more of /solver/substeps") != std::string::npos)
        << stiff[0];
    ASSERT_EQ(damped.size(), 1u);
    EXPECT_TRUE(damped[0].starts_with("/materials/gel: soft bodies show a damping of ")) << damped[0];
}

}  // namespace
}  // namespace knuckle::test
