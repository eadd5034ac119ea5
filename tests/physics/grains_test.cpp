#include <algorithm>
#include <cmath>
#include <random>

#include "tests/physics/physics_fixture.h"

namespace knuckle::test {

namespace {

/// A cone of loose particles on a floor, with jittered places so that no lattice holds them up.
World steepHeap(float mu, float radius, float slope)
{
    WorldBuilder builder = makeBuilder({}, mu);
    builder.addCollider(floorPlane(mu));
    std::mt19937 random(1);
    const auto share = [&] { return static_cast<float>(random() >> 8) * 0x1p-23f - 1.0f; };
    const float height = radius * std::tan(slope);
    const int reach = static_cast<int>(radius) + 1;
    for (int y = 0; static_cast<float>(y) < height; ++y)
        for (int z = -reach; z <= reach; ++z)
            for (int x = -reach; x <= reach; ++x) {
                const float shift = y % 2 == 0 ? 0.0f : 0.25f;
                const Vector3f p = 1.04f * Eigen::Vector3i(x, y, z).cast<float>() + Vector3f(shift, 0.5f, shift);
                if (std::hypot(p.x(), p.z()) > radius * (1.0f - p.y() / (height + 0.5f))) continue;
                Vector3f shaken = p;
                for (float& side : shaken) side += 0.15f * share();
                Particle grain;
                grain.position = grain.restPosition = DIAMETER * (shaken + Vector3f(0, 0.15f, 0));
                builder.addLooseParticle(grain);
            }
    return builder.build();
}

/// Slope of a heap about the y axis [degrees]: of the line fitted to the mean heights of the highest grains in patches
/// of 1 x 1.6 diameters, between a fifth and four fifths of its height.
double slopeOf(const std::vector<Vector3f>& grains)
{
    std::vector<std::vector<double>> tops(60);
    for (size_t r = 0; r < tops.size(); ++r)
        tops[r].assign(std::max(1, static_cast<int>(2.0 * M_PI * (static_cast<double>(r) + 0.5) / 1.6)), 0.0);
    for (const Vector3f& p : grains) {
        const auto ring = static_cast<size_t>(std::hypot(p.x(), p.z()) / DIAMETER);
        if (ring >= tops.size()) continue;
        const size_t patches = tops[ring].size();
        const double turn = (std::atan2(p.z(), p.x()) + M_PI) / (2.0 * M_PI);
        double& top = tops[ring][static_cast<size_t>(turn * static_cast<double>(patches)) % patches];
        top = std::max(top, static_cast<double>(p.y()) + 0.5 * DIAMETER);
    }
    std::vector<double> heights;
    for (const auto& ring : tops) {
        double sum = 0.0;
        for (double top : ring) sum += top;
        heights.push_back(sum / static_cast<double>(ring.size()));
    }
    const double highest = *std::max_element(heights.begin(), heights.end());
    double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (size_t r = 0; r < heights.size(); ++r) {
        if (heights[r] < 0.2 * highest || heights[r] > 0.8 * highest) continue;
        const double x = (static_cast<double>(r) + 0.5) * DIAMETER;
        n += 1;
        sx += x;
        sy += heights[r];
        sxx += x * x;
        sxy += x * heights[r];
    }
    return std::atan(-(n * sxy - sx * sy) / (n * sxx - sx * sx)) * 180.0 / M_PI;
}

}  // namespace

TEST(Grains, AHeapThatIsTooSteepCollapsesToTheSlopeOfItsFrictionAndStays)
{
    for (float mu : {0.3f, 0.5f, 0.7f}) {
        const float repose = std::atan(mu);
        const World world = steepHeap(mu, 14.0f, repose + 0.18f);
        Solver solver(gpu(), world);
        run(solver, world, 3.0);
        const double slope = slopeOf(solver.readParticles().positions);
        EXPECT_NEAR(slope, repose * 180.0 / M_PI, 5.0) << "friction " << mu;
        run(solver, world, 1.5);
        // A tenth of the tolerance for the slope itself: a grain that slips shifts the mean of its patch.
        EXPECT_NEAR(slopeOf(solver.readParticles().positions), slope, 0.5) << "friction " << mu;
    }
}

TEST(Grains, NothingIsFasterThanTheMaximumSpeed)
{
    Settings settings;
    settings.maxSpeed = 2.0f;
    WorldBuilder builder = makeBuilder(settings);
    Particle grain;
    grain.position = {3, 0, 0};
    builder.addLooseParticle(grain);
    addBox(builder, {3, 3, 3}, {}, {0, 1, 0}, {0, 30, 0});
    const World world = builder.build();
    Solver solver(gpu(), world);
    run(solver, world, 1.0);
    for (const Vector3f& v : solver.readParticles().velocities) EXPECT_LE(v.norm(), 2.0f * (1 + 1e-5f));
    // Reached after 2 / g seconds and kept afterwards; a substep of 1/240 s adds gravity's part before the limit
    // applies.
    const double fallen = 2.0 * (1.0 - 2.0 / GRAVITY) + 0.5 * 4.0 / GRAVITY;
    EXPECT_NEAR(solver.readParticles().positions[0].y(), -fallen, GRAVITY / 240.0);
}

TEST(Grains, MassScalingHasTheUpperOfTwoGiveWay)
{
    Settings settings;
    settings.gravity = {0, -1e-4f, 0};  // only to define up
    settings.massScaling = 5.0f;
    WorldBuilder builder = makeBuilder(settings);
    Particle grain;
    builder.addLooseParticle(grain);
    grain.position = {0, 1.5f * DIAMETER, 0};
    grain.velocity = {0, -1, 0};
    builder.addLooseParticle(grain);
    const World world = builder.build();
    Solver solver(gpu(), world);
    run(solver, world, 0.5);
    // Inelastic, with masses 1 and exp(-k d) at the place where they meet.
    const double upper = std::exp(-5.0 * DIAMETER), together = -upper / (1.0 + upper);
    const auto velocities = solver.readParticles().velocities;
    // With these masses they exchange all momentum; they meet slightly nearer or further away, 1 %.
    EXPECT_NEAR(velocities[0].y() + upper * velocities[1].y(), -upper, 0.01 * upper);
    // They do not quite stay together: they part with 3.5 % of their speed of approach.
    for (const Vector3f& v : velocities) EXPECT_NEAR(v.y(), together, 0.03);
}

}  // namespace knuckle::test
