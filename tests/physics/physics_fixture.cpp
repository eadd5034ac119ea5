#include "tests/physics/physics_fixture.h"

#include <cmath>

namespace knuckle::test {

Gpu& gpu()
{
    static Gpu instance;
    return instance;
}

WorldBuilder makeBuilder(const Settings& settings, float friction)
{
    WorldBuilder builder(DIAMETER / 2, settings);
    Material material;
    material.name = "test";
    material.staticFriction = material.kineticFriction = friction;
    builder.addMaterial(material);
    return builder;
}

Settings weightless()
{
    Settings settings;
    settings.gravity.setZero();
    return settings;
}

uint32_t addBox(WorldBuilder& builder, const Eigen::Vector3i& counts, const Pose& pose, const Vector3f& velocity,
                const Vector3f& spin)
{
    builder.beginObject("box");
    const uint32_t body = builder.addBody("box", boxLattice(counts, DIAMETER), 0);
    builder.endObject(pose, velocity, spin);
    return body;
}

World jointedPair(JointType type, const Settings& settings, const Pose& pose, const Vector3f& velocity,
                  const Vector3f& spin, bool fixed, int limitSide)
{
    WorldBuilder builder = makeBuilder(settings);
    PairSpec pair;
    pair.joint.type = type;
    pair.joint.limitSide = limitSide;
    pair.motionOfA = fixed ? Motion::Fixed : Motion::Dynamic;
    addJointedPair(builder, pair, pose, velocity, spin);
    return builder.build();
}

void beginRow(WorldBuilder& builder, uint32_t bodies, JointType type)
{
    builder.beginObject("row");
    for (uint32_t b = 0; b < bodies; ++b) {
        std::vector<Vector3f> places = boxLattice({3, 3, 3}, DIAMETER);
        for (Vector3f& p : places) p.x() += 4 * DIAMETER * static_cast<float>(b);
        builder.addBody("body", places, 0);
    }
    for (uint32_t b = 0; b + 1 < bodies; ++b) {
        JointSpec spec;
        spec.type = type;
        spec.anchor.x() = 4 * DIAMETER * (static_cast<float>(b) + 0.5f);
        builder.addJoint(b, b + 1, spec);
    }
    builder.setSelfMargin(50.0f);
}

uint32_t particleAt(const WorldBuilder& builder, const Vector3f& place)
{
    for (uint32_t i = builder.particleCount(); i-- > 0;)
        if ((builder.world().particles[i].position - place).norm() < 0.1f * DIAMETER) return i;
    return NO_INDEX;
}

Collider floorPlane(float friction)
{
    Collider plane;
    plane.staticFriction = plane.kineticFriction = friction;
    return plane;
}

void run(Solver& solver, const World& world, double seconds)
{
    const int steps = static_cast<int>(std::lround(seconds / world.settings.timeStep));
    for (int i = 0; i < steps; ++i) {
        solver.step();
        solver.checkCounters(static_cast<uint64_t>(i));
    }
}

Totals totals(const World& world, const ParticleState& state)
{
    Totals sum;
    for (size_t i = 0; i < world.particles.size(); ++i) {
        const double mass = world.particles[i].mass;
        const Eigen::Vector3d v = state.velocities[i].cast<double>();
        sum.momentum += mass * v;
        sum.angularMomentum += mass * state.positions[i].cast<double>().cross(v);
        sum.speedSum += mass * v.norm();
    }
    return sum;
}

double energyOf(const World& world, const ParticleState& state)
{
    double sum = 0.0;
    for (size_t i = 0; i < state.positions.size(); ++i) {
        const double height = state.positions[i].y(), speed = state.velocities[i].norm();
        sum += world.particles[i].mass * (0.5 * speed * speed + GRAVITY * height);
    }
    return sum;
}

double reducedLength(const World& world, uint32_t body, const Vector3f& hinge)
{
    const Body& swinging = world.bodies[body];
    double inertia = 0.0;
    Eigen::Vector2d moment = Eigen::Vector2d::Zero();
    for (uint32_t l = swinging.linkStart; l < swinging.linkStart + swinging.linkCount; ++l) {
        const Vector3f arm = world.links[l].restOffset + swinging.restCentre - hinge;
        inertia += world.links[l].mass * arm.head<2>().squaredNorm();
        moment += world.links[l].mass * arm.head<2>().cast<double>();
    }
    return inertia / moment.norm();
}

float lowestBody(const std::vector<BodyState>& bodies)
{
    float lowest = INFINITY;
    for (const BodyState& body : bodies) lowest = std::min(lowest, body.position.y());
    return lowest;
}

}  // namespace knuckle::test
