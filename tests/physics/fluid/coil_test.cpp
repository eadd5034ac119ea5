#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/physics/fluid/tank.h"

namespace knuckle::test {

namespace {

constexpr float SPACING = 0.015f, RADIUS = 0.03f, HEIGHT = 0.45f, SPEED = 0.4f;
constexpr float VISCOSITY = 3000.0f, DENSITY = 1400.0f;

/// A jet of honey, four particles across, that falls on a floor.
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
/// layers would be 1.5 and 2.4 times as far apart as at rest.
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
        EXPECT_LT(apart, 1.3f * SPACING) << k;
    }
}

/// Ribe 2004, "Coiling of viscous jets": where gravity bends the thread against its viscosity, it turns at
/// (g Q^3 / (nu a^8))^(1/4), a being its radius, which is the nozzle's while it is as fast; here 10 rad/s. That is a
/// law of scales, so a factor of two. It begins slower; measured 6.4 rad/s in the turns from 4 s on.
TEST(Coil, TurnsAsFastAsRibeSays)
{
    const World world = honeyJet();
    Solver solver(gpu(), world);
    run(solver, world, 4.0);
    constexpr double LASTS = 2.0, INTERVAL = 1.0 / 30;
    double turned = 0.0;
    Vector3f before = middleOf(solver.readParticles());
    for (int k = 0; k < static_cast<int>(LASTS / INTERVAL); ++k) {
        run(solver, world, INTERVAL);
        const Vector3f now = middleOf(solver.readParticles());
        turned += std::atan2(before.z() * now.x() - before.x() * now.z(), before.x() * now.x() + before.z() * now.z());
        before = now;
    }
    const double flow = std::numbers::pi * RADIUS * RADIUS * SPEED;
    const double truth = std::pow(GRAVITY * std::pow(flow, 3) / (VISCOSITY / DENSITY * std::pow(RADIUS, 8)), 0.25);
    EXPECT_GT(std::abs(turned) / LASTS, 0.5 * truth);
    EXPECT_LT(std::abs(turned) / LASTS, 2.0 * truth);
}

}  // namespace knuckle::test
