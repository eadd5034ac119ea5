#include <gtest/gtest.h>

#include "app/scene/scene_file.h"
#include "sim/world/fingerprint/fingerprint.h"
#include "tests/places.h"
#include "tests/temp_folder.h"

namespace knuckle::test {
namespace {

const char* const SCENE = R"({ "diameter": 0.1, "colliders": [{ "type": "plane" }],
    "materials": { "clay": {}, "water": { "fluid": true } },
    "objects": [{ "type": "actor", "name": "crate", "file": "MODEL", "material": "clay" },
                { "type": "cloth", "position": [0, 3, 0] }, { "type": "soft", "shape": "box", "position": [2, 1, 0] },
                { "type": "fluid", "shape": "box", "size": [0.5, 0.5, 0.5], "position": [4, 1, 0],
                  "material": "water" }],
    "render": { "width": 640 } })";

class SceneFingerprint : public testing::Test {
protected:
    SceneFingerprint()
    {
        std::string text = SCENE;
        text.replace(text.find("MODEL"), 5, inSource("assets/models/crate.glb"));
        file_ = folder_.write("scene.json", text);
    }
    uint64_t with(const std::vector<Override>& overrides) const
    {
        return fingerprint(loadScene(file_, overrides).world);
    }

private:
    TempFolder folder_;
    std::string file_;
};

TEST_F(SceneFingerprint, OfTwoLoadsIsOne)
{
    EXPECT_EQ(with({}), with({}));
}

TEST_F(SceneFingerprint, ChangesWithWhatTheSolverIsTold)
{
    const uint64_t plain = with({});
    for (const Override& change : std::vector<Override>{{"solver.gravity", {0, -9.8, 0}},
                                                        {"solver.iterations", 3},
                                                        {"solver.substeps", 9},
                                                        {"materials.clay.staticFriction", 0.6},
                                                        {"materials.water.viscosity", 0.01},
                                                        {"objects.0.position", {0, 0.001, 0}},
                                                        {"objects.0.velocity", {0, 0, 1}},
                                                        {"objects.1.position", {0, 3.001, 0}},
                                                        {"colliders.0.staticFriction", 0.1}})
        EXPECT_NE(with({change}), plain) << change.path << " = " << change.value;
    for (const Override& change : std::vector<Override>{{"objects.0.name", "other"},
                                                        {"render.width", 320},
                                                        {"materials.clay.color", {1, 0, 0}},
                                                        {"colliders.0.visible", false},
                                                        {"objects.0.skin", "particles"}})
        EXPECT_EQ(with({change}), plain) << change.path << " = " << change.value;
}

}  // namespace
}  // namespace knuckle::test
