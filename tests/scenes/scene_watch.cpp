#include "tests/scenes/scene_watch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sim/solver/layout/body_mass.h"
#include "tests/places.h"

namespace knuckle::test {

namespace {

/// Kinetic and gravitational energy above the floor of everything present [J]. Bodies have the solver's inertia: that
/// of a ball is the solid's, which is more than that of its particles' centres.
class Energy {
public:
    Energy(const World& world, float floor) : world_(world), floor_(floor)
    {
        for (const Body& body : world.bodies) {
            const BodyMass mass = bodyMass(world, body);
            inertias_.emplace_back(mass.moments.trace() * Eigen::Matrix3d::Identity() - mass.moments);
            masses_.push_back(mass.mass);
        }
    }

    double of(const ParticleState& particles, const std::vector<BodyState>& bodies) const
    {
        double sum = 0.0;
        for (size_t i = 0; i < particles.positions.size(); ++i)
            if (world_.particles[i].body == NO_INDEX)
                sum += world_.particles[i].mass * share(particles.positions[i], particles.velocities[i]);
        for (size_t b = 0; b < bodies.size(); ++b) {
            const Vector3f turning = bodies[b].rotation.conjugate() * bodies[b].angularVelocity;
            const Eigen::Vector3d spin = turning.cast<double>();
            sum += masses_[b] * share(bodies[b].position, bodies[b].velocity) + 0.5 * spin.dot(inertias_[b] * spin);
        }
        return sum;
    }

private:
    /// Energy per kilogram.
    double share(const Vector3f& position, const Vector3f& velocity) const
    {
        return 0.5 * velocity.cast<double>().squaredNorm() + 9.81 * (position.y() - floor_);
    }

    const World& world_;
    double floor_;
    std::vector<Eigen::Matrix3d> inertias_;
    std::vector<double> masses_;
};

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

/// Keeps the worse value of each measure.
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
    const Energy energy(world, floor);
    const double start = energy.of(solver.readParticles(), solver.readBodies());
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
        const double now = energy.of(state, solver.readBodies());
        raise(worst.rise, static_cast<float>((now - least) / start));
        least = std::min(least, now);
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
