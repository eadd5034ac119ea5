#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "sim/solver/measure/state.h"
#include "tests/places.h"
#include "tests/scenes/scene_watch.h"
#include "tests/temp_folder.h"

namespace knuckle::test {

namespace {

/// The figure alone, without gravity and pins, driven from the start. @param drive fields of its `drive`.
Scene drivenFigure(const std::string& drive)
{
    const TempFolder folder;
    return loadScene(folder.write("scene.json", R"({"duration": 8, "diameter": 0.04, "solver": {"gravity": [0, 0, 0]},
        "objects": [{"type": "actor", "file": ")" + inSource("assets/models/humanoid.glb") +
                                                    R"(", "animation": {"clip": "dance"}, "drive": {)" + drive +
                                                    R"(, "pin": {"frequency": 0}}}]})"));
}

/// Mean square of the joints' differences from their clip [rad2].
double squaredError(const World& world, const std::vector<BodyState>& bodies, double time)
{
    const std::vector<Pose> clip = bodyPlaces(world, world.animations[0], time);
    double sum = 0.0;
    for (const Joint& joint : world.joints) {
        const Quaternionf is = bodies[joint.parent].rotation.conjugate() * bodies[joint.child].rotation;
        const Quaternionf wanted = clip[joint.parent].rotation.conjugate() * clip[joint.child].rotation;
        sum += std::pow(double{is.angularDistance(wanted)}, 2);
    }
    return sum / static_cast<double>(world.joints.size());
}

/// About the origin, and the sum of the sizes of the particles' parts.
struct Turning {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double size = 0.0;
};

Turning turningOf(const World& world, const ParticleState& state)
{
    Turning all;
    for (size_t i = 0; i < world.particles.size(); ++i) {
        const Eigen::Vector3d part = double{world.particles[i].mass} *
                                     state.positions[i].cast<double>().cross(state.velocities[i].cast<double>());
        all.sum += part;
        all.size += part.norm();
    }
    return all;
}

}  // namespace

/// Measured 1.4 degrees; at 5 Hz 3.6.
TEST(Driven, TheFigureFollowsItsDance)
{
    const Scene scene = drivenFigure(R"("frequency": 10)");
    const World& world = scene.world;
    Solver solver(gpu(), world);
    double squares = 0.0;
    constexpr int STEPS = 300;
    for (int i = 1; i <= STEPS; ++i) {
        solver.step();
        squares += squaredError(world, solver.readBodies(), i * double{world.settings.timeStep});
    }
    solver.checkCounters(0);
    EXPECT_LT(std::sqrt(squares / STEPS), 5.0 * std::numbers::pi / 180);
}

/// In free flight drives act within the figure: neither momentum nor angular momentum changes until its shins touch,
/// since friction there acts at the particles' centres.
TEST(Driven, TheFigureKeepsItsAngularMomentum)
{
    const Scene scene = drivenFigure(R"("frequency": 10)");
    Solver solver(gpu(), scene.world);
    solver.step();
    const Turning before = turningOf(scene.world, solver.readParticles());
    for (int i = 0; i < 80; ++i) {
        solver.step();
        const Turning now = turningOf(scene.world, solver.readParticles());
        ASSERT_LT((now.sum - before.sum).norm(), 1e-4 * now.size) << "step " << i;
    }
}

/// Three balls make it stagger, and it returns to its dance. The last one knocks it out.
TEST(Driven, TheDancerRecoversFromAllBallsButTheLast)
{
    const Scene scene = sceneOf("hit", {});
    const World& world = scene.world;
    Solver solver(gpu(), world);
    float farthest = 0.0f;
    const auto away = [&](double time) {
        const std::vector<Pose> clip = bodyPlaces(world, world.animations[0], time);
        return (solver.readBodies()[0].position - clip[0].translation).norm();
    };
    const int steps = static_cast<int>(5.9 / world.settings.timeStep);
    for (int i = 1; i <= steps; ++i) {
        solver.step();
        const double time = i * double{world.settings.timeStep};
        farthest = std::max(farthest, away(time));
        if (i % 10 == 0) solver.checkCounters(0);
    }
    EXPECT_GT(farthest, 0.05f);
    EXPECT_LT(farthest, 0.3f);
    // Its weight alone pulls it down by 0.15 m while no foot carries it.
    EXPECT_LT(away(steps * double{world.settings.timeStep}), 0.15f);
    EXPECT_EQ(solver.measure().knockedOutCount, 0u);
    const Watched fall = watch(solver, scene, 1.9, 0);
    EXPECT_EQ(solver.measure().knockedOutCount, 1u);
    EXPECT_LT(solver.readBodies()[0].position.y(), 0.3f);
    EXPECT_LT(fall.gap, 0.05f);
}

/// It lies at the foot of the stairs, is caught without a jump, and is then at its clip's place.
TEST(Driven, TheFallenDancerIsCaughtAndDancesOn)
{
    const Scene scene = sceneOf("catch", {});
    const World& world = scene.world;
    Solver solver(gpu(), world);
    const double step = double{world.settings.timeStep};
    const auto until = [&](int from, double time, auto each) {
        int i = from;
        for (; i * step < time; ++i) {
            solver.step();
            each();
        }
        solver.checkCounters(0);
        return i;
    };
    int steps = until(0, 4.4, [] {});
    EXPECT_LT(solver.readBodies()[0].position.y(), 0.4f);
    std::vector<BodyState> before = solver.readBodies();
    float change = 0.0f;
    steps = until(steps, 8.5, [&] {
        const std::vector<BodyState> now = solver.readBodies();
        for (size_t b = 0; b < now.size(); ++b)
            change = std::max(change, (now[b].velocity - before[b].velocity).norm());
        before = now;
    });
    // The dance alone has 1.6 m/s a frame, when a foot lands.
    EXPECT_LT(change, 4.0f);
    EXPECT_EQ(solver.measure().caughtCount, 1u);
    EXPECT_LT(squaredError(world, solver.readBodies(), steps * step), 1e-8);
    EXPECT_GT(solver.readBodies()[0].position.y(), 0.6f);
}

}  // namespace knuckle::test
