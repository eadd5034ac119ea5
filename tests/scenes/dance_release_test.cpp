#include <gtest/gtest.h>

#include "tests/places.h"
#include "tests/scenes/scene_watch.h"
#include "tests/temp_folder.h"

namespace knuckle::test {

namespace {

/// The figure, dancing on the ground. @param release of it. @param objects further ones.
Scene dancer(const std::string& release, const std::string& objects = "")
{
    const TempFolder folder;
    return loadScene(folder.write("scene.json",
                                  R"({"duration": 8, "diameter": 0.04, "colliders": [{"type": "plane"}],
        "objects": [{"type": "actor", "name": "dancer", "file": ")" +
                                      inSource("assets/models/humanoid.glb") +
                                      R"(", "position": [0, 0.02, 0], "animation": {"clip": "dance"}, "release": )" +
                                      release + "}" + objects + "]}"));
}

/// The figures of `--stats` for bodies let go within a time [s].
std::vector<ReleaseFigures> figuresOf(const Scene& scene, double seconds)
{
    Solver solver(gpu(), scene.world);
    solver.noteReleases();
    ReleaseLog log(scene.world);
    for (double t = 0; t < seconds; t += scene.world.settings.timeStep) {
        solver.step();
        solver.checkCounters(0);
        log.add(solver.letGo());
        if (log.wantsGaps()) log.addGaps(solver.readParticles(), solver.readBodies());
    }
    return log.figures();
}

/// Typical measured values: momentum 1e-7, a body 0.4 %, gaps 1e-4 of a diameter. If limbs touch in that very substep,
/// its speeds are of first order after a prediction of second: momentum lacks a third of gravity's part, 0.6 %.
void expectSmooth(const ReleaseFigures& release)
{
    EXPECT_LT(release.momentumChange, 0.01 * release.momentum) << "at " << release.time;
    EXPECT_LT(release.worstBodyChange, 0.02f * release.fastest) << "at " << release.time;
    EXPECT_LT(release.worstGap, 0.05f * 0.04f) << "at " << release.time;
}

}  // namespace

/// Ten moments of steps, turn and leap, with gravity, and with the soles above the ground, which would push back.
TEST(DanceRelease, MotionGoesOnWhenTheDancerIsLetGo)
{
    for (const double time : {0.4, 1.1, 1.7, 2.3, 2.9, 3.6, 4.9, 5.2, 5.5, 7.2}) {
        const auto releases = figuresOf(dancer(R"({"clipTime": )" + std::to_string(time) + "}"), time + 0.2);
        ASSERT_EQ(releases.size(), 1u);
        EXPECT_EQ(releases[0].bodies, 18u);
        EXPECT_NEAR(releases[0].time, time, 0.01);
        expectSmooth(releases[0]);
    }
}

/// By a blow, by a touch, in a region, for a part.
TEST(DanceRelease, MotionGoesOnWhateverLetsGo)
{
    const std::string ball = R"(, {"type": "rigid", "name": "ball", "shape": "sphere", "radius": 0.12,
        "position": [0, 1.2, 3], "velocity": [0, 1.5, -4]})";
    const struct {
        std::string release;
        double earliest, latest;
        uint32_t bodies;
    } cases[] = {
        {R"({"impulse": 12})", 0.6, 0.8, 18},
        {R"({"touch": "ball"})", 0.6, 0.8, 18},
        {R"({"touch": "ball", "below": "thigh.R"})", 0.6, 0.8, 3},
        {R"({"region": {"shape": "sphere", "radius": 0.3, "position": [0, 1.8, 0]}})", 0.0, 0.1, 18},
        {R"({"time": 0.5, "below": "upper_arm.R"})", 0.5, 0.5, 3},
    };
    for (const auto& one : cases) {
        SCOPED_TRACE(one.release);
        const auto releases = figuresOf(dancer(one.release, ball), 1.1);
        ASSERT_EQ(releases.size(), 1u);
        EXPECT_EQ(releases[0].bodies, one.bodies);
        EXPECT_GE(releases[0].time, one.earliest - 1e-3);
        EXPECT_LE(releases[0].time, one.latest + 1e-3);
        expectSmooth(releases[0]);
    }
}

}  // namespace knuckle::test
