#include <gtest/gtest.h>

#include "app/scene_file.h"
#include "sim/solver/solver.h"
#include "tests/render/golden.h"
#include "tests/render/render_fixture.h"

namespace knuckle::test {
namespace {

/// The scene's film after two steps: what it is made of, its colours, light and camera. What happens later would change
/// with every detail of the solver.
Image opening(const std::string& name)
{
    Scene scene = loadScene(std::string(KNUCKLE_ROOT) + "/assets/scenes/" + name + ".json");
    scene.render.width = 160;
    scene.render.height = 90;
    Gpu& gpu = sharedGpu();
    Solver solver(gpu, scene.world);
    for (int i = 0; i < 2; ++i) solver.step();
    solver.checkCounters(2);
    Renderer renderer(gpu, scene.world, scene.render);
    renderer.draw(solver.view(), 2.0 * scene.world.settings.timeStep);
    Image image = renderer.readImage();
    EXPECT_NO_THROW(gpu.checkErrors());
    return image;
}

class SceneGolden : public testing::TestWithParam<const char*> {};

TEST_P(SceneGolden, OpensAsItDid)
{
    expectGolden(std::string("scene_") + GetParam(), opening(GetParam()));
}

INSTANTIATE_TEST_SUITE_P(Films, SceneGolden,
                         testing::Values("dam", "float", "layers", "sand", "curtain", "chandelier", "jelly",
                                         "potpourri"),
                         [](const auto& test) { return std::string(test.param); });

}  // namespace
}  // namespace knuckle::test
