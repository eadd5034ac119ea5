#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "physics_test.h"
#include "sim/world/rope.h"

namespace knuckle::test {

namespace {

constexpr float LENGTH = 2.0f;

/// Mass of a rope of the tests' material [kg]: half of a particle stays in each end.
double ropeMass(const World& world)
{
    double mass = 0.0;
    for (const Particle& p : world.particles) mass += p.body == NO_INDEX ? p.mass : 0.0;
    return mass;
}

/// A cube hangs below the origin on a rope along -y. @returns the cube's body.
uint32_t hangCube(WorldBuilder& builder, const RopeSpec& common, uint32_t material)
{
    RopeSpec rope = common;
    rope.to = {0, -LENGTH, 0};
    rope.start.kind = RopeEnd::Kind::Fixed;
    builder.beginObject("cube");
    const uint32_t body = builder.addBody("cube", boxLattice({3, 3, 3}, DIAMETER), material);
    builder.endObject({{0, -LENGTH - DIAMETER, 0}});
    // The middle of its upper side.
    for (uint32_t i = 0; i < builder.particleCount(); ++i)
        if ((builder.world().particles[i].position - rope.to).norm() < 0.1f * DIAMETER)
            rope.end = {RopeEnd::Kind::Attached, i};
    addRope(builder, "rope", rope);
    return body;
}

/// How long a world's one rope is: the sum of its distances [m].
double lengthOf(const World& world, const ParticleState& state)
{
    double length = 0.0;
    const auto& nodes = world.strands[0].particles;
    for (size_t k = 1; k < nodes.size(); ++k)
        length += (state.positions[nodes[k]] - state.positions[nodes[k - 1]]).cast<double>().norm();
    return length;
}

double meanLength(const World& world, double settle)
{
    Solver solver(gpu(), world);
    run(solver, world, settle);
    double sum = 0.0;
    for (int i = 0; i < 120; ++i) {
        run(solver, world, world.settings.timeStep);
        sum += lengthOf(world, solver.readParticles());
    }
    return sum / 120;
}

}  // namespace

/// A rope from the origin to `to` that a loose particle of `mass` ends [kg]. @returns its index.
uint32_t addPendulum(WorldBuilder& builder, const Vector3f& to, float mass)
{
    Particle bob;
    bob.position = to;
    bob.mass = mass;
    const uint32_t index = builder.addLooseParticle(bob);
    RopeSpec rope;
    rope.start.kind = RopeEnd::Kind::Fixed;
    rope.end = {RopeEnd::Kind::Attached, index};
    addRope(builder, "rope", rope);
    return index;
}

/// The slowest period of small swings of a hanging chain, by its nodes' masses from the top down [s]: the tension in a
/// link is the weight below it, and pulls its ends sideways together by it over the length.
double slowestPeriod(const std::vector<double>& masses, double link)
{
    const auto n = static_cast<Eigen::Index>(masses.size());
    Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(n, n), inertia = Eigen::MatrixXd::Zero(n, n);
    double below = 0.0;
    for (Eigen::Index k = n - 1; k >= 0; --k) {
        below += masses[static_cast<size_t>(k)];
        inertia(k, k) = masses[static_cast<size_t>(k)];
        const double pull = below * GRAVITY / link;   // of the link above the node
        stiffness(k, k) += pull;
        if (k == 0) continue;
        stiffness(k - 1, k - 1) += pull;
        stiffness(k, k - 1) -= pull;
        stiffness(k - 1, k) -= pull;
    }
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> modes(stiffness, inertia);
    return 2 * M_PI / std::sqrt(modes.eigenvalues()[0]);
}

TEST(Rope, probe)
{
    for (float mass : {0.2f, 20.0f, 2000.0f})
        for (float angle : {0.1f, 0.5f}) {
        WorldBuilder builder = makeBuilder();
        const uint32_t bob = addPendulum(builder, {LENGTH * std::sin(angle), -LENGTH * std::cos(angle), 0}, mass);
        const World world = builder.build();
        std::vector<double> masses;
        const auto& nodes = world.strands[0].particles;
        for (size_t k = 1; k < nodes.size(); ++k) masses.push_back(world.particles[nodes[k]].mass);
        const double truth = slowestPeriod(masses, world.strands[0].restLengths[0]);
        Solver solver(gpu(), world);
        std::vector<double> crossings;
        std::vector<double> maxima;
        double last = 0, best = 0;
        const double h = world.settings.timeStep;
        double e0 = 0, e = 0;
        for (int i = 1; i * h < 11.5 * truth; ++i) {
            run(solver, world, h);
            const ParticleState state = solver.readParticles();
            e = 0;
            for (size_t k = 0; k < world.particles.size(); ++k)
                if (world.particles[k].body == NO_INDEX)
                    e += world.particles[k].mass *
                         (0.5 * state.velocities[k].squaredNorm() + GRAVITY * state.positions[k].y());
            if (i == 1) e0 = e;
            const double x = state.positions[bob].x();
            best = std::max(best, std::abs(x));
            if (last > 0 && x <= 0) {
                crossings.push_back((i - 1 + last / (last - x)) * h);
                maxima.push_back(best);
                best = 0;
            }
            last = x;
        }
        std::printf("mass %g angle %g: period %.5f of truth, amplitude %.4f, energy %g -> %g, worst %g\n", mass, angle,
                    (crossings.back() - crossings[0]) / double(crossings.size() - 1) / truth,
                    maxima.back() / maxima[0], e0, e, lengthOf(world, solver.readParticles()) - LENGTH);
    }
    // Falls free and jerks.
    for (float mass : {1.0f, 100.0f}) {
        WorldBuilder builder = makeBuilder();
        RopeSpec rope;
        rope.from = {0, 0, 0};
        rope.to = {0.5, 0, 0};
        rope.length = 2;
        rope.start.kind = RopeEnd::Kind::Fixed;
        Particle bobP;
        bobP.position = rope.to;
        bobP.mass = mass;
        const uint32_t bob = builder.addLooseParticle(bobP);
        rope.end = {RopeEnd::Kind::Attached, bob};
        addRope(builder, "rope", rope);
        const World world = builder.build();
        Solver solver(gpu(), world);
        for (int i = 0; i < 90; ++i) {
            run(solver, world, world.settings.timeStep);
            const ParticleState state = solver.readParticles();
            double e = 0, fastest = 0;
            for (size_t k = 0; k < world.particles.size(); ++k)
                if (world.particles[k].body == NO_INDEX) {
                    e += world.particles[k].mass *
                         (0.5 * state.velocities[k].squaredNorm() + GRAVITY * state.positions[k].y());
                    fastest = std::max<double>(fastest, state.velocities[k].norm());
                }
            if (i % 3 == 0)
                std::printf("%d: %.3f %.3f v %.3f energy %.3f length %.5f fastest %.2f\n", i, state.positions[bob].x(),
                            state.positions[bob].y(), state.velocities[bob].y(), e, lengthOf(world, state), fastest);
        }
    }
}

}  // namespace knuckle::test
