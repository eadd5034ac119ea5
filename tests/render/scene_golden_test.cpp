#include <gtest/gtest.h>

#include "app/scene/scene_file.h"
#include "sim/solver/solver.h"
#include "tests/places.h"
#include "tests/render/golden.h"
#include "tests/render/render_fixture.h"

namespace knuckle::test {
namespace {

/// The scene's film after some steps, with its materials, colours, light and camera.
Image picture(const std::string& name, int steps, const std::vector<Override>& overrides = {})
{
    Scene scene = loadScene(test::inSource("assets/scenes/" + name + ".json"), overrides);
    scene.render.width = 160;
    scene.render.height = 90;
    // The triangles of coarse levels depend on the library's version.
    scene.render.skinError = 0.0f;
    Gpu& gpu = sharedGpu();
    Solver solver(gpu, scene.world);
    for (int i = 0; i < steps; ++i) solver.step();
    solver.checkCounters(static_cast<uint64_t>(steps));
    Renderer renderer(gpu, scene.world, scene.render);
    renderer.draw(solver.view(), steps * static_cast<double>(scene.world.settings.timeStep));
    Image image = renderer.readImage();
    EXPECT_NO_THROW(gpu.checkErrors());
    return image;
}

class SceneGolden : public testing::TestWithParam<const char*> {};

TEST_P(SceneGolden, OpensAsItDid)
{
    // Two steps only: later pictures would change with every detail of the solver.
    expectGolden(std::string("scene_") + GetParam(), picture(GetParam(), 2));
}

INSTANTIATE_TEST_SUITE_P(Films, SceneGolden,
                         testing::Values("dam", "float", "layers", "sand", "curtain", "chandelier", "jelly",
                                         "potpourri"),
                         [](const auto& test) { return std::string(test.param); });

/// The dancer 0.2 s before its release in the leap, and in its fall, before limbs meet the floor. It begins to dance
/// late, so that nothing lies around yet, which would differ with each change of the solver.
class DanceGolden : public testing::TestWithParam<int> {};

TEST_P(DanceGolden, LooksAsItDid)
{
    expectGolden("dance_" + std::to_string(GetParam()),
                 picture("dance", GetParam(), {{"objects.0.animation.start", 4.9}}));
}

INSTANTIATE_TEST_SUITE_P(Steps, DanceGolden, testing::Values(12, 42),
                         [](const auto& test) { return std::to_string(test.param); });

class PaperGolden : public testing::TestWithParam<const char*> {};

TEST_P(PaperGolden, LooksAsItDidAfterASecond)
{
    // Scenes that are not chaotic by then: things that stand, or swing from a joint.
    expectGolden(std::string("paper_") + GetParam(), picture(GetParam(), 60, {{"solver", "paper"}}));
}

INSTANTIATE_TEST_SUITE_P(Films, PaperGolden, testing::Values("tower", "joints"),
                         [](const auto& test) { return std::string(test.param); });

}  // namespace
}  // namespace knuckle::test
