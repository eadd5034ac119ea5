#include <numbers>

#include "app/film/film_steps.h"
#include "tests/render/lens/lens_scene.h"
#include "tests/temp_folder.h"

namespace knuckle::test {
namespace {

constexpr const char* FLYING_BALL = R"({
    "solver": { "gravity": [0, 0, 0] }, "diameter": 0.1, "duration": 0.5, "fps": 30,
    "camera": { "position": [0, 0, 3], "target": [0, 0, 0] },
    "light": { "intensity": 0, "skyColor": [1, 1, 1], "groundColor": [1, 1, 1] },
    "render": { "width": 128, "height": 128, "toneMap": "linear", "background": [0, 0, 0], "quality": "final",
                "samples": 32 },
    "objects": [{ "type": "rigid", "shape": "sphere", "radius": 0.1, "position": [-0.5, 0, 0], "velocity": [6, 0, 0],
                  "draw": "shape" }] })";

/// Frame 4 of the ball's film.
Image fourthFrame(float shutter)
{
    const TempFolder folder;
    const Scene scene = loadScene(folder.write("scene.json", FLYING_BALL), {{"render.shutter", shutter}});
    Solver solver(sharedGpu(), scene.world);
    FilmSteps steps(sharedGpu(), scene, solver);
    Renderer renderer(sharedGpu(), scene.world, scene.render);
    for (uint64_t frame = 2; frame <= 4; ++frame) {
        steps.advance(
            frame, [&] { solver.step(); },
            [&](const ParticleView& view, const Moment& moment, uint32_t draw) {
                renderer.expose(view, moment.time, draw);
            });
        if (const auto draw = ownDraw(scene, frame, 1)) renderer.expose(steps.view(), scene.timeOf(frame), *draw);
        else renderer.draw(steps.view(), scene.timeOf(frame));
    }
    Image image = renderer.readImage();
    EXPECT_NO_THROW(sharedGpu().checkErrors());
    return image;
}

TEST(Shutter, LeavesAStreakOfSpeedTimesTime)
{
    constexpr double DRAWS = 32, SPEED = 6.0, DISTANCE = 3.0;
    const Spread still = spreadOf(fourthFrame(0.0f));
    for (const float shutter : {90.0f, 180.0f, 360.0f}) {
        const Spread streak = spreadOf(fourthFrame(shutter));
        EXPECT_NEAR(streak.sum / still.sum, 1.0, 0.01) << shutter;
        const double pixels = SPEED * shutter / 360.0 / 30.0 / DISTANCE * SIZE /
                              (2.0 * std::tan(std::numbers::pi / 9.0));
        // The places are a lattice of DRAWS points over the way: its mean square is way^2 / 12 (n + 1) / (n - 1).
        const double way = std::sqrt(12.0 * (streak.square - still.square) * (DRAWS - 1) / (DRAWS + 1));
        EXPECT_NEAR(way, pixels, 1.0) << shutter;
        // It ends where the frame's own moment is.
        EXPECT_NEAR(still.x - streak.x, 0.5 * pixels, 0.5) << shutter;
    }
}

TEST(Shutter, HasItsMomentsWithinTheFramesShot)
{
    const TempFolder folder;
    const std::string shots = R"("shots": [{ "from": 0 }, { "from": 0.1, "timeScale": 0.5 }], )";
    std::string text = FLYING_BALL;
    const Scene scene = loadScene(folder.write("scene.json", text.insert(1, shots)),
                                  {{"render.shutter", 360}, {"render.samples", 4}});
    // Frame 4 is at 0.1 s: all that is before is of the other shot.
    for (const Moment& moment : momentsBefore(scene, 4)) EXPECT_EQ(moment.time, scene.render.shots[1].from);
    const std::vector<Moment> moments = momentsBefore(scene, 5);
    ASSERT_EQ(moments.size(), 3u);
    for (size_t k = 0; k < 3; ++k) {
        EXPECT_NEAR(moments[k].place, double(k) / 3.0, 1e-12);
        EXPECT_NEAR(moments[k].time, (3.0 + double(k) / 3.0) / 30.0, 1e-12);
    }
}

}  // namespace
}  // namespace knuckle::test
