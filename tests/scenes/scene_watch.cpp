#include "tests/scenes/scene_watch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/places.h"

namespace knuckle::test {

namespace {

/// Kinetic and in gravity above the floor, of all that is there [J].
double energyOf(const World& world, const ParticleState& state, float floor)
{
    double sum = 0.0;
    for (size_t i = 0; i < state.positions.size(); ++i) {
        const double height = state.positions[i].y() - floor, speed = state.velocities[i].norm();
        sum += world.particles[i].mass * (0.5 * speed * speed + 9.81 * height);
    }
    return sum;
}

bool isFinite(const ParticleState& state)
{
    const auto finite = [](const Vector3f& v) { return v.allFinite(); };
    return std::all_of(state.positions.begin(), state.positions.end(), finite) &&
           std::all_of(state.velocities.begin(), state.velocities.end(), finite);
}

void raise(float& worst, float value)
{
    worst = std::max(worst, value);
}

/// Takes over what is worse in a frame.
void addMeasures(Watched& worst, const Measures& m, float diameter)
{
    raise(worst.gap, m.worstJointGap / diameter);
    raise(worst.penetration, m.worstPenetration / diameter);
    raise(worst.meanPenetration, m.meanPenetration / diameter);
    raise(worst.shapeError, m.worstShapeError / diameter);
    raise(worst.speed, m.maxSpeed);
    raise(worst.stretch, m.meanStretch);
    raise(worst.strain, m.meanSoftStrain);
    raise(worst.densityError, m.meanDensityError);
}

}  // namespace

Gpu& gpu()
{
    static Gpu gpu;
    return gpu;
}

Scene sceneOf(const std::string& name, const std::vector<std::string>& changes)
{
    std::vector<Override> overrides;
    for (const std::string& change : changes) overrides.push_back(parseOverride(change));
    return loadScene(inSource("assets/scenes/") + name + ".json", overrides);
}

Watched watch(Solver& solver, const Scene& scene, double seconds, float floor)
{
    const World& world = scene.world;
    const double start = energyOf(world, solver.readParticles(), floor);
    double least = start;
    Watched worst;
    const auto frames = static_cast<uint64_t>(std::lround(seconds * scene.framesPerSecond));
    for (uint64_t frame = 1; frame <= frames; ++frame) {
        for (uint32_t k = 0; k < scene.stepsPerFrame; ++k) solver.step();
        EXPECT_NO_THROW(solver.checkCounters(frame)) << "frame " << frame;
        const ParticleState state = solver.readParticles();
        EXPECT_TRUE(isFinite(state)) << "frame " << frame;
        if (testing::Test::HasFailure()) break;
        addMeasures(worst, solver.measure(), world.diameter());
        const double energy = energyOf(world, state, floor);
        raise(worst.rise, static_cast<float>((energy - least) / start));
        least = std::min(least, energy);
        for (const Vector3f& p : state.positions) {
            raise(worst.low, (floor - p.y()) / world.diameter());
            raise(worst.far, std::max(std::abs(p.x()), std::abs(p.z())));
        }
    }
    return worst;
}

double meanSpeed(const Scene& scene, Solver& solver)
{
    double mass = 0.0;
    for (const Particle& p : scene.world.particles) mass += p.mass;
    return std::sqrt(2.0 * solver.measure().kineticEnergy / mass);
}

}  // namespace knuckle::test
