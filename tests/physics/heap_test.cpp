#include <algorithm>
#include <cmath>

#include "sim/world/matter/grain.h"
#include "tests/physics/heap_fixture.h"

namespace knuckle::test {

namespace {

double degrees(double mu)
{
    return std::atan(mu) * 180.0 / M_PI;
}

/// Mean speed of all particles [m/s].
double meanSpeed(const ParticleState& state)
{
    double sum = 0.0;
    for (const Vector3f& v : state.velocities) sum += v.norm();
    return sum / static_cast<double>(state.velocities.size());
}

/// How many grains there are from place x on, per row of `width` grains a diameter [diameters of height].
double heightAt(const std::vector<Vector3f>& grains, int x, float width)
{
    const auto isThere = [&](const Vector3f& p) { return static_cast<int>(std::floor(p.x() / DIAMETER)) == x; };
    return static_cast<double>(std::ranges::count_if(grains, isThere)) / width;
}

}  // namespace

TEST(Heap, OnePouredIsAsSteepAsItsFriction)
{
    for (float mu : {0.35f, 0.7f}) {
        // A heap of a thousand grains that has just slid is up to 2.5 degrees flatter than before: the mean of two.
        double slope = 0.0;
        for (float lift : {0.0f, 0.13f}) {
            Settings gentle;
            gentle.maxSpeed = 2.0f;
            GrainFill fill(mu, gentle);
            fill.fill({-3, 1 + lift, -3}, {3, 90 + lift, 3}, 1.5f);
            const World world = fill.build();
            Solver solver(gpu(), world);
            run(solver, world, 6.0);
            slope += 0.5 * slopeOf(solver.readParticles().positions);
        }
        EXPECT_NEAR(slope, degrees(mu), 3.0) << "friction " << mu;
    }
}

TEST(Heap, AConeThatIsTooSteepCollapsesToTheSlopeOfItsFrictionAndStays)
{
    const float mu = 0.5f, radius = 14.0f;
    GrainFill fill(mu);
    const auto inCone = [&](const Vector3f& p) { return std::hypot(p.x(), p.z()) < radius - p.y(); };
    fill.fill({-15, 0.15f, -15}, {15, 14, 15}, 1.0f, inCone);
    const World world = fill.build();
    Solver solver(gpu(), world);
    run(solver, world, 3.0);
    const double slope = slopeOf(solver.readParticles().positions);
    EXPECT_NEAR(slope, degrees(mu), 3.0);
    // Less than a hundredth of a diameter in a tenth of a second.
    EXPECT_LT(meanSpeed(solver.readParticles()), 0.1 * DIAMETER);
    run(solver, world, 1.5);
    // A grain at the tip or the foot shifts the mean of its ring, and the line by a degree.
    EXPECT_NEAR(slopeOf(solver.readParticles().positions), slope, 1.5);
}

TEST(Heap, OneLeftOnAPlatformIsAsSteepAsItsFriction)
{
    const float mu = 0.5f, half = 9.0f, top = 6.0f;
    GrainFill fill(mu);
    fill.addWall({-half, 0, -half}, {half, top, half}, mu);
    fill.fill({-half, top, -half}, {half, top + 10, half}, 1.0f);
    const World world = fill.build();
    Solver solver(gpu(), world);
    run(solver, world, 4.0);
    // The brink holds a layer, a tenth of the height here, and what is left has not slid as far as it could.
    EXPECT_NEAR(slopeOf(solver.readParticles().positions, DIAMETER * top), degrees(mu), 5.0);
}

TEST(Heap, RollingFrictionAddsToItsSlope)
{
    Material sand;
    sand.staticFriction = sand.kineticFriction = 0.7f;
    Material rough = sand;
    rough.staticFriction = rough.kineticFriction = 0.5f;
    rough.rollingFriction = 0.2f;
    EXPECT_FLOAT_EQ(grainFriction(rough).sticking, grainFriction(sand).sticking);
    EXPECT_FLOAT_EQ(grainFriction(rough).sliding, grainFriction(sand).sliding);
}

TEST(Heap, AColumnsCollapseRunsAsFarAsLajeunesseFound)
{
    const float mu = 0.4f, length = 20.0f, width = 5.0f;
    const auto addTo = [&](GrainFill& fill) {
        fill.addWall({-5, 0, -9}, {0, 60, 9}, 0.0f);
        for (float side : {-1.0f, 1.0f})
            fill.addWall({-5, 0, side * width / 2 + std::min(side * 5.0f, 0.0f)},
                         {100, 60, side * width / 2 + std::max(side * 5.0f, 0.0f)}, 0.0f);
    };
    GrainFill behindGate(mu);
    addTo(behindGate);
    behindGate.addWall({length, 0, -9}, {length + 5, 60, 9}, 0.0f);
    behindGate.fill({0, 0.15f, -width / 2}, {length, 23.15f, width / 2}, 1.0f);
    const World still = behindGate.build();
    Solver settling(gpu(), still);
    run(settling, still, 1.0);
    GrainFill fill(mu);
    addTo(fill);
    for (const Vector3f& place : settling.readParticles().positions) fill.addGrain(place);
    const World world = fill.build();
    const double grains = static_cast<double>(world.particles.size());
    Solver solver(gpu(), world);
    run(solver, world, 2.5);
    const std::vector<Vector3f> positions = solver.readParticles().positions;
    int front = 0;
    while (heightAt(positions, front, width) + heightAt(positions, front + 1, width) > 1.0) ++front;
    // Lajeunesse et al. 2005, eq. 8: 1.2 a for a < 2.3; a by the volume, of which grains fill 0.62.
    const double a = grains * M_PI / 6.0 * 1.043 / 0.62 / (width * length * length);
    EXPECT_NEAR((static_cast<double>(front) - length) / length, 1.2 * a, 0.12 * a);
}

TEST(Heap, ASiloRunsOutAtBeverloosRate)
{
    const float mu = 0.5f, hole = 6.0f, half = 8.0f, floor = 12.0f;
    GrainFill fill(mu);
    for (float side : {-1.0f, 1.0f}) {
        const float inner = side * half, outer = side * (half + 4), edge = side * hole / 2;
        fill.addWall({std::min(inner, outer), floor, -12}, {std::max(inner, outer), 60, 12}, mu);
        fill.addWall({-12, floor, std::min(inner, outer)}, {12, 60, std::max(inner, outer)}, mu);
        fill.addWall({std::min(edge, outer), floor - 2, -12}, {std::max(edge, outer), floor, 12}, mu);
        fill.addWall({-hole / 2, floor - 2, std::min(edge, outer)}, {hole / 2, floor, std::max(edge, outer)}, mu);
    }
    fill.fill({-half, floor, -half}, {half, floor + 14, half}, 1.0f);
    const World world = fill.build();
    Solver solver(gpu(), world);
    const auto left = [&] {
        const auto isIn = [&](const Vector3f& p) { return p.y() > DIAMETER * floor; };
        return static_cast<double>(std::ranges::count_if(solver.readParticles().positions, isIn));
    };
    run(solver, world, 0.5);
    const double atFirst = left();
    run(solver, world, 2.0);
    const double between = left();
    run(solver, world, 2.0);
    const double atLast = left();
    // Beverloo et al. 1961 for a hole of area A and hydraulic diameter D, both without 1.5 d at the rims: C 4/pi of the
    // bulk's density times A sqrt(g D), C from 0.5 to 0.65. Grains come in bursts, of some 600 in two seconds.
    const double open = DIAMETER * (hole - 1.5), bulk = 0.6 / (M_PI / 6.0 * 1.043 * std::pow(DIAMETER, 3));
    const double rate = 0.575 * 4.0 / M_PI * bulk * std::sqrt(GRAVITY * open) * open * open;
    EXPECT_NEAR((atFirst - between) / 2.0, rate, 0.2 * rate);
    EXPECT_NEAR(between - atLast, atFirst - between, 0.1 * (atFirst - between));
}

}  // namespace knuckle::test
