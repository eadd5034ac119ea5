#include <algorithm>
#include <cmath>
#include <map>

#include "tests/physics/heap_fixture.h"

namespace knuckle::test {

namespace {

constexpr float MU = 0.5f, RADIUS = 2.5f * DIAMETER, REST = 0.7f;

/// Mean height of the highest grains in squares of 1.5 diameters, from one distance from the middle to another [m].
double surfaceAt(const World& world, const std::vector<Vector3f>& places, float from, float to)
{
    std::map<std::pair<int, int>, float> tops;
    for (size_t i = 0; i < places.size(); ++i) {
        const Vector3f& p = places[i];
        const float away = std::hypot(p.x(), p.z());
        if (world.particles[i].body != NO_INDEX || away < from || away > to) continue;
        const auto cell = [](float x) { return static_cast<int>(std::floor(x / (1.5f * DIAMETER))); };
        float& top = tops.try_emplace({cell(p.x()), cell(p.z())}, 0.0f).first->second;
        top = std::max(top, p.y() + 0.5f * DIAMETER);
    }
    double sum = 0.0;
    for (const auto& [cell, top] : tops) sum += double{top};
    return sum / static_cast<double>(tops.size());
}

}  // namespace

/// Uehara et al. 2003: a ball of the diameter D that falls by H, to the bottom of its crater, comes to rest at
/// d = 0.14 / mu (ball's density / grains')^(1/2) D^(2/3) H^(1/3) below the surface.
TEST(Crater, IsAsDeepAsUeharaFound)
{
    for (const auto& [density, height] : {std::pair(2000.0f, 2.0f), {6000.0f, 0.6f}}) {
        SCOPED_TRACE(std::to_string(density) + " kg/m3 from " + std::to_string(height) + " m");
        GrainFill fill(MU);
        fill.fill({-11, 0.1f, -11}, {11, 11, 11}, 1.0f);
        fill.addWall({-12, 0, -12}, {-11, 14, 12}, MU);
        fill.addWall({11, 0, -12}, {12, 14, 12}, MU);
        fill.addWall({-12, 0, -12}, {12, 14, -11}, MU);
        fill.addWall({-12, 0, 11}, {12, 14, 12}, MU);
        const uint32_t ball = fill.addBall(RADIUS, {0, 1.0f + RADIUS + height, 0}, density, REST);
        const World world = fill.build();
        Solver solver(gpu(), world);
        run(solver, world, REST);
        ParticleState state = solver.readParticles();
        const double surface = surfaceAt(world, state.positions, 0.0f, 0.9f);
        double grains = 0.0;
        for (size_t i = 0; i < world.particles.size(); ++i)
            if (world.particles[i].body == NO_INDEX) grains += double{world.particles[i].mass};
        const double bulk = grains / (2.2 * 2.2 * surface);
        const double fall = double{world.bodies[ball].position.y() - RADIUS} - surface;
        double fastest = 0.0, struck = 0.0, before = energyOf(world, state), gained = 0.0;
        const double start = before;
        const int steps = static_cast<int>((std::sqrt(2 * fall / GRAVITY) + 0.8) * 60);
        for (int k = 0; k < steps; ++k) {
            run(solver, world, world.settings.timeStep);
            state = solver.readParticles();
            for (size_t i = 0; i < world.particles.size(); ++i)
                if (world.particles[i].body == NO_INDEX)
                    fastest = std::max(fastest, double{state.velocities[i].norm()});
            struck = std::max(struck, double{solver.readBodies()[ball].velocity.norm()});
            const double now = energyOf(world, state);
            gained += std::max(now - before, 0.0);
            before = now;
            // A bed that rests breathes by 0.3 % of its height.
            EXPECT_LT(now, start * 1.005);
        }
        const double depth = surface - double{solver.readBodies()[ball].position.y() - RADIUS};
        const double truth = 0.14 / double{MU} * std::sqrt(double{density} / bulk) *
                             std::pow(2.0 * double{RADIUS}, 2.0 / 3.0) * std::cbrt(fall + depth);
        // Their balls of 25 grains and more scatter by a tenth about the line; of one of five grains it is half a
        // grain, 15 % of the depth, more or less. Measured 20 % too little, 14 % too much.
        EXPECT_NEAR(depth, truth, 0.25 * truth);
        // Grains are as fast as the ball, and what recovery adds, 0.25 m/s at a contact. Measured 0.34.
        EXPECT_LT(fastest, struck + 0.5);
        // A crater, and flat ground around it.
        EXPECT_LT(surfaceAt(world, state.positions, 0.0f, 0.25f), surface - DIAMETER);
        EXPECT_NEAR(surfaceAt(world, state.positions, 0.6f, 1.0f), surface, 0.3 * DIAMETER);
        // The blow presses grains into each other, and as they part again they lift the ball: energy from nothing.
        // Measured 0.40 of what the ball brings, a tenth of it the bed's breathing.
        EXPECT_LT(gained, 0.5 * world.bodies[ball].mass * GRAVITY * fall);
        std::printf("depth %.3f of %.3f m, gained %.2f\n", depth, truth,
                    gained / (world.bodies[ball].mass * GRAVITY * fall));
    }
}

}  // namespace knuckle::test
