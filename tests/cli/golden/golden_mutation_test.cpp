#include <fmt/format.h>

#include <filesystem>

#include "tests/cli/cli_fixture.h"
#include "tests/places.h"

namespace knuckle::test {
namespace {

/// Breaks what the project's own goldens hold, and looks whether they say so, and of what. Every mutation is small on
/// the picture.
class GoldenMutation : public CliTest {
protected:
    RunResult check(const std::string& golden, std::vector<std::string> more) const
    {
        more.insert(more.begin(), {"golden", "check", inSource("tests/golden"), golden});
        return run(more);
    }
    /// With a shader in which some words are others.
    RunResult checkShader(const std::string& golden, const std::string& part, const std::string& shader,
                          const std::string& before, const std::string& after) const
    {
        std::string text = readText(inSource("shaders/" + shader));
        const size_t at = text.find(before);
        EXPECT_NE(at, std::string::npos) << shader << " has no " << before;
        const std::filesystem::path file = folder.path("shaders/" + shader);
        std::filesystem::create_directories(file.parent_path());
        folder.write("shaders/" + shader, text.replace(at, before.size(), after));
        return check(golden, {part, "--shaders", folder.path("shaders")});
    }
    /// Does not draw some particles.
    RunResult checkWithout(const std::string& golden, uint32_t begin, uint32_t end) const
    {
        return checkShader(golden, "--pictures", "render/spheres/sphere_cull.comp", "bool shown = isShown(i, position)",
                           fmt::format("bool shown = (i < {}u || i >= {}u) && isShown(i, position)", begin, end));
    }
    static void expectDrawing(const RunResult& result, const std::string& what)
    {
        EXPECT_EQ(result.code, 4) << what << result.err;
        EXPECT_NE(result.out.find(": drawing: different: "), std::string::npos) << what << result.out;
        EXPECT_NE(result.out.find("the difference is in "), std::string::npos) << what << result.out;
        EXPECT_EQ(result.out.find("physics"), std::string::npos) << what << result.out;
    }
    static void expectPhysics(const RunResult& result, const std::string& what)
    {
        EXPECT_EQ(result.code, 4) << what << result.err;
        EXPECT_NE(result.out.find(": physics: different: "), std::string::npos) << what << result.out;
        EXPECT_EQ(result.out.find("drawing"), std::string::npos) << what << result.out;
    }
};

TEST_F(GoldenMutation, OfWhatIsDrawnIsCaughtAndNamed)
{
    // The ball of `hello`, whose particles come after those of the slab.
    expectDrawing(checkWithout("quick/hello", 120, 233), "a ball is gone\n");
    expectDrawing(checkWithout("modes/material", 524, 555), "a forearm and its hand are gone\n");
    // The foremost of the cube.
    expectDrawing(checkWithout("quick/hello", 309, 310), "a particle is gone\n");
    expectDrawing(checkShader("quick/hit", "--pictures", "render/picture/soft_shadow.glsl",
                              "return outside ? 1.0 :", "return true ? 1.0 :"),
                  "shadows are gone\n");
    // By 2 degrees about the vertical.
    expectDrawing(check("quick/hit", {"--set", "light.direction=[-0.484,0.85,0.467]"}), "the light has moved\n");
    expectDrawing(check("modes/material", {"--set", "materials.clay.color=[0.618,0.2575,0.1236]"}),
                  "a colour is 3 % brighter\n");
}

TEST_F(GoldenMutation, OfPhysicsIsCaughtAndNamed)
{
    expectPhysics(check("quick/hello", {"--set", "solver.gravity=[0,-9.7119,0]"}), "gravity is 1 % less\n");
    expectPhysics(check("quick/hit", {"--set", "solver.substeps=7"}), "one substep less\n");
    expectPhysics(check("quick/hit", {"--set", "colliders.3.position=[-1.5,0.45,1.65]"}), "a collider has moved\n");
    expectPhysics(checkShader("quick/ragdoll", "--states", "sim/joint/limits/joint_limit_states.glsl",
                              "atan(sine, along) - limits.swing", "atan(sine, along) - limits.swing - 0.0873"),
                  "joints stop 5 degrees earlier\n");
}

}  // namespace
}  // namespace knuckle::test
