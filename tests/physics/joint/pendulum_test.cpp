#include <cmath>

#include "tests/physics/physics_fixture.h"

namespace knuckle::test {

/// Periods of a swing by its downward zero crossings, and its amplitudes.
struct Swing {
    double period = 0.0;         ///< [s], over the first ten swings.
    double amplitudeKept = 0.0;  ///< Of the eleventh maximum, relative to the first.
};

/// A body of `counts` particles hung by one edge on a hinge along z through the origin, swung by `angle`.
/// @param reducedLength returns I about the axis over m l, so that T = 2 pi sqrt(reducedLength / g) [m].
World hangingBody(const Eigen::Vector3i& counts, float angle, double& reducedLength)
{
    WorldBuilder builder = makeBuilder();
    std::vector<Vector3f> points = boxLattice(counts, DIAMETER);
    const float drop = 0.5f * DIAMETER * static_cast<float>(counts.y() - 1);
    double inertia = 0.0, moment = 0.0;
    const Eigen::AngleAxisf turn(angle, Vector3f::UnitZ());
    for (Vector3f& p : points) {
        p.y() -= drop;
        inertia += p.x() * p.x() + p.y() * p.y();
        moment -= p.y();
        p = turn * p;
    }
    reducedLength = inertia / moment;
    builder.beginObject("pendulum");
    const std::vector<Vector3f> axis = {{0, 0, -DIAMETER}, {0, 0, 0}, {0, 0, DIAMETER}};
    builder.addBody("pivot", axis, 0, Motion::Fixed);
    // The particles on the axis are the pivot's.
    std::vector<Vector3f> own;
    for (const Vector3f& p : points)
        if (p.head<2>().norm() > 0.1f * DIAMETER) own.push_back(p);
    const uint32_t body = builder.addBody("bob", own, 0);
    for (uint32_t p = 0; p < 3; ++p) builder.shareParticle(p, body);
    builder.endObject();
    return builder.build();
}

Swing measure(const World& world, double expectedPeriod)
{
    Solver solver(gpu(), world);
    std::vector<double> crossings, maxima;
    double last = 0.0, best = 0.0;
    const double h = world.settings.timeStep;
    for (int i = 1; i * h < 11.5 * expectedPeriod; ++i) {
        run(solver, world, h);
        const double x = solver.readBodies()[1].position.x();
        best = std::max(best, std::abs(x));
        if (i > 1 && last > 0.0 && x <= 0.0) {
            crossings.push_back((i - 1 + last / (last - x)) * h);
            maxima.push_back(best);
            best = 0.0;
        }
        last = x;
    }
    Swing swing;
    if (crossings.size() < 11) return swing;
    swing.period = (crossings[10] - crossings[0]) / 10.0;
    swing.amplitudeKept = maxima[10] / maxima[0];
    return swing;
}

/// Checks that the period is within 1 % of the lattice's own, and that 90 % of the amplitude is left after ten swings.
void expectSwings(const Eigen::Vector3i& counts)
{
    double reducedLength = 0.0;
    const World world = hangingBody(counts, 0.1f, reducedLength);
    // The finite-amplitude correction 1 + a^2/16 is 0.06 % at 0.1 rad.
    const double truth = 2.0 * M_PI * std::sqrt(reducedLength / GRAVITY);
    const Swing swing = measure(world, truth);
    EXPECT_NEAR(swing.period, truth, 0.006 * truth);  // measured 7e-4
    EXPECT_GT(swing.amplitudeKept, 0.9);
    std::printf("period %.4f of the lattice's, amplitude kept %.3f\n", swing.period / truth, swing.amplitudeKept);
}

TEST(Pendulum, ACubeOnAHingeSwingsWithItsPeriod)
{
    expectSwings({3, 6, 3});
}

TEST(Pendulum, ARodOfOneMetreSwingsWithItsPeriod)
{
    // Eleven layers extend from 0 to 1 m. Lattice: I/(m l) = (2 n + 1)/(3 n) * L with n = 10, 0.7 m, and the width's
    // part; the continuum's 2/3 m gives 1.638 s.
    expectSwings({3, 11, 3});
}

}  // namespace knuckle::test
