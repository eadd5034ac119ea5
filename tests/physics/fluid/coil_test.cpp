#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/physics/fluid/tank.h"

namespace knuckle::test {

namespace {

constexpr float SPACING = 0.02f, RADIUS = 0.03f, HEIGHT = 0.45f, SPEED = 0.4f;
constexpr float VISCOSITY = 3000.0f, DENSITY = 1400.0f;

/// A jet of honey, three particles across, that falls on a floor.
World honeyJet()
{
    WorldBuilder builder(2 * SPACING);
    addPlane(builder, {0, 0, 0}, {0, 1, 0});
    Material honey;
    honey.fluid = true;
    honey.density = DENSITY;
    honey.viscosity = VISCOSITY;
    Emitter emitter;
    emitter.material = builder.addMaterial(honey);
    emitter.pool = 3000;
    emitter.nozzle = placed(discNozzle(RADIUS, SPACING), {0, HEIGHT, 0}, {0, -1, 0});
    emitter.velocity = {0, -SPEED, 0};
    builder.addEmitter(emitter);
    return builder.build();
}

/// The middle of the thread where it is 0.6 of the height above the floor.
Vector3f middleOf(const ParticleState& state)
{
    Vector3f sum = Vector3f::Zero();
    int count = 0;
    for (size_t i = 0; i < state.positions.size(); ++i) {
        if (state.inactive[i] || std::abs(state.positions[i].y() - 0.6f * HEIGHT) > 0.05f * HEIGHT) continue;
        sum += state.positions[i];
        ++count;
    }
    return sum / static_cast<float>(std::max(count, 1));
}

}  // namespace

/// Fluid that follows holds what has just left; then the weight of the thread stretches it a little. In free fall
/// layers would be 1.6 and 2.8 times as far apart as at rest.
TEST(Coil, AThreadLeavesItsNozzleInOnePiece)
{
    const World world = honeyJet();
    Solver solver(gpu(), world);
    run(solver, world, 1.0);
    const ParticleState state = solver.readParticles();
    const size_t layer = world.emitters[0].nozzle.points.size();
    const auto leaving = static_cast<size_t>(std::ranges::count(state.inactive, false)) - layer;
    for (size_t k = 0; k < 3; ++k) {
        const float apart = state.positions[leaving - k * layer].y() - state.positions[leaving - (k + 1) * layer].y();
        EXPECT_GT(apart, 0.7f * SPACING) << k;
        EXPECT_LT(apart, 1.45f * SPACING) << k;
    }
}

/// Ribe 2004, "Coiling of viscous jets": where gravity bends the thread against its viscosity, it turns at
/// (g Q^3 / (nu a^8))^(1/4), a being its radius, which is the nozzle's while it is as fast; here 10 rad/s. That is a
/// law of scales, known to a factor. Measured 0.50 of it in these first turns; 0.62 of it with s = 0.015 m over ten
/// seconds.
TEST(Coil, TurnsAsFastAsRibeSays)
{
    const World world = honeyJet();
    Solver solver(gpu(), world);
    run(solver, world, 3.5);
    constexpr double LASTS = 2.0, INTERVAL = 1.0 / 30;
    std::vector<Vector3f> places;
    Vector3f centre = Vector3f::Zero();
    for (int k = 0; k < static_cast<int>(LASTS / INTERVAL); ++k) {
        run(solver, world, INTERVAL);
        places.push_back(middleOf(solver.readParticles()));
        centre += places.back();
    }
    centre /= static_cast<float>(places.size());
    double turned = 0.0;
    for (size_t k = 0; k + 1 < places.size(); ++k) {
        const Vector3f before = places[k] - centre, now = places[k + 1] - centre;
        turned += std::atan2(before.z() * now.x() - before.x() * now.z(), before.x() * now.x() + before.z() * now.z());
    }
    const double flow = std::numbers::pi * RADIUS * RADIUS * SPEED;
    const double truth = std::pow(GRAVITY * std::pow(flow, 3) / (VISCOSITY / DENSITY * std::pow(RADIUS, 8)), 0.25);
    EXPECT_GT(std::abs(turned) / LASTS, 0.4 * truth);
    EXPECT_LT(std::abs(turned) / LASTS, 2.0 * truth);
}

}  // namespace knuckle::test
