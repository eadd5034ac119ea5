#include <cmath>

#include "tests/physics/physics_fixture.h"

namespace knuckle::test {

namespace {

/// A single soft box, on a frictionless floor if requested.
World softBox(const Eigen::Vector3i& counts, const Elasticity& elasticity, const Settings& settings, bool floor,
              float height, const Vector3f& velocity = {0, 0, 0}, const Vector3f& spin = {0, 0, 0})
{
    WorldBuilder builder(DIAMETER / 2, settings);
    Material material;
    material.name = "jelly";
    material.staticFriction = material.kineticFriction = 0.0f;
    material.elasticity = elasticity;
    builder.addMaterial(material);
    if (floor) builder.addCollider(floorPlane(0.0f));
    builder.beginObject("jelly");
    builder.addSoftBody("jelly", boxLattice(counts, DIAMETER), 0);
    builder.endObject({Vector3f(0, height, 0)}, velocity, spin);
    return builder.build();
}

Elasticity jelly(float stiffness, float poissonRatio = 0.0f)
{
    Elasticity out;
    out.stiffness = stiffness;
    out.poissonRatio = poissonRatio;
    out.damping = 0.02f;
    return out;
}

Settings stepped(uint32_t substeps, uint32_t iterations)
{
    Settings settings;
    settings.substeps = substeps;
    settings.iterations = iterations;
    return settings;
}

/// Mean height of the particles that were highest at the start, less that of the lowest [m].
double heightOf(const World& world, const ParticleState& state)
{
    float top = -INFINITY, bottom = INFINITY;
    for (const Particle& p : world.particles) {
        top = std::max(top, p.position.y());
        bottom = std::min(bottom, p.position.y());
    }
    double sums[2] = {0, 0}, counts[2] = {0, 0};
    for (size_t i = 0; i < world.particles.size(); ++i) {
        const float y = world.particles[i].position.y();
        if (y < top - 0.01f && y > bottom + 0.01f) continue;
        const int side = y > bottom + 0.01f ? 0 : 1;
        sums[side] += state.positions[i].y();
        counts[side] += 1;
    }
    return sums[0] / counts[0] - sums[1] / counts[1];
}

constexpr int LAYERS = 9;
constexpr float REST_HEIGHT = (LAYERS - 1) * DIAMETER;

/// How much lower a standing column of nine layers becomes by its weight [m].
double sag(const Elasticity& elasticity, const Settings& settings, double seconds = 2.5)
{
    const World world = softBox({5, LAYERS, 5}, elasticity, settings, true, 0.5f * LAYERS * DIAMETER);
    Solver solver(gpu(), world);
    run(solver, world, seconds);
    return REST_HEIGHT - heightOf(world, solver.readParticles());
}

/// Elastic stress is nominal (force over the area at rest) and Poisson's ratio 0: continuum theory says
/// rho g H (n - 1) d / (2 E) between the middles of the outer layers of n. Clusters carry the mass of the outer layers
/// too, which makes a body of n layers stiffer by n / (n - 1).
double wantedSag(float stiffness)
{
    const double height = LAYERS * DIAMETER;
    return 1000.0 * GRAVITY * height * REST_HEIGHT / (2.0 * stiffness) * REST_HEIGHT / height;
}

TEST(SoftBody, AColumnSagsAsItsStiffnessSays)
{
    // At 5 % strain: half of what a column of finite layers and clusters may differ by. Measured: 1.008, 1.031.
    EXPECT_NEAR(sag(jelly(1e5f), stepped(4, 2)), wantedSag(1e5f), 0.05 * wantedSag(1e5f));
    EXPECT_NEAR(sag(jelly(5e4f), stepped(4, 2)), wantedSag(5e4f), 0.05 * wantedSag(5e4f));
}

/// How far the free end of a column of nine layers moves by its weight if a layer is pinned, at default settings [m].
/// @param pinned the layer, counted from below.
double pinnedSag(float stiffness, int pinned, double seconds = 2.5)
{
    WorldBuilder builder(DIAMETER / 2);
    Material material;
    material.elasticity = jelly(stiffness);
    builder.addMaterial(material);
    const std::vector<Vector3f> lattice = boxLattice({5, LAYERS, 5}, DIAMETER);
    std::vector<uint32_t> pins;
    for (uint32_t i = 0; i < lattice.size(); ++i)
        if (std::lround((lattice[i].y() + 0.5f * REST_HEIGHT) / DIAMETER) == pinned) pins.push_back(i);
    builder.beginObject("column");
    builder.addSoftBody("column", lattice, 0, pins);
    builder.endObject();
    const World world = builder.build();
    Solver solver(gpu(), world);
    run(solver, world, seconds);
    const ParticleState state = solver.readParticles();
    for (uint32_t i : pins) EXPECT_EQ((state.positions[i] - world.particles[i].position).norm(), 0.0f);
    return std::abs(REST_HEIGHT - heightOf(world, state));
}

/// It is held in the middle of the pinned layer; half a layer is beyond the middle of the free one: each piece between
/// carries what is farther out.
double wantedPinnedSag(float stiffness)
{
    return 1000.0 * GRAVITY / double(stiffness) * REST_HEIGHT * (REST_HEIGHT + 0.5 * DIAMETER - 0.5 * REST_HEIGHT);
}

TEST(SoftBody, APinnedColumnSagsStandingAndHanging)
{
    // Of weights that hang from the pinned layer as well as those on it. Strains of 8 % are not quite linear.
    for (int pinned : {0, LAYERS - 1}) {
        SCOPED_TRACE(pinned);
        EXPECT_NEAR(pinnedSag(8e4f, pinned), wantedPinnedSag(8e4f), 0.05 * wantedPinnedSag(8e4f));
    }
}

TEST(SoftBody, AStiffColumnIsAsStiffAsAsked)
{
    // The sag is 3 % of a diameter; two iterations would make it 2.5 times as much.
    EXPECT_NEAR(pinnedSag(1e6f, LAYERS - 1, 0.7), wantedPinnedSag(1e6f), 0.05 * wantedPinnedSag(1e6f));
}

TEST(SoftBody, TheSagDependsLittleOnIterationsAndSubsteps)
{
    double least = INFINITY, most = 0.0;
    for (const auto& [substeps, iterations] : {std::pair{8u, 1u}, {4u, 2u}, {4u, 4u}, {16u, 2u}}) {
        const double found = sag(jelly(4e4f), stepped(substeps, iterations), 4.0);
        least = std::min(least, found);
        most = std::max(most, found);
    }
    // After 4 s 1 % of the swing is left, exp(-w^2 damping / 2 t) with w = pi / 2 sqrt(E / density) / H. Measured: 1.8
    // %.
    EXPECT_LT(most - least, 0.03 * least) << least << " to " << most << " m";
}

TEST(SoftBody, ATumblingCubeKeepsMomentumAndAngularMomentum)
{
    for (float stiffness : {5e3f, 1e6f}) {
        SCOPED_TRACE(stiffness);
        const World world = softBox({5, 5, 5}, jelly(stiffness, 0.3f), weightless(), false, 1.0f, {0.3f, 0.1f, -0.2f},
                                    {0.5f, 1.0f, 2.0f});
        Solver solver(gpu(), world);
        const Totals before = totals(world, solver.readParticles());
        run(solver, world, 5.0);
        const Totals after = totals(world, solver.readParticles());
        // Measured 5e-5, from rounding, and 1.4e-4.
        EXPECT_LT((after.momentum - before.momentum).norm(), 1e-4 * before.speedSum);
        EXPECT_LT((after.angularMomentum - before.angularMomentum).norm(), 4e-4 * before.angularMomentum.norm());
    }
}

/// Mean strain of a cube that falls by 0.5 m: the largest during the fall, and that at rest.
std::pair<float, float> strainOfFall(float creep)
{
    Elasticity elasticity = jelly(3e4f, 0.3f);
    elasticity.creep = creep;
    const World world = softBox({5, 5, 5}, elasticity, {}, true, 0.75f);
    Solver solver(gpu(), world);
    float most = 0.0f;
    for (int k = 0; k < 15; ++k) {
        run(solver, world, 0.2);
        most = std::max(most, solver.measure().meanSoftStrain);
    }
    return {most, solver.measure().meanSoftStrain};
}

TEST(SoftBody, ADroppedCubeSpringsBackUnlessItFlows)
{
    const auto [most, elastic] = strainOfFall(0.0f);
    const auto [plasticMost, plastic] = strainOfFall(100.0f);
    // At rest its own weight strains it by rho g H / (2 E) = 8 % at most; it lands with 2 g 0.5 m / 2 = 5 J/kg, which
    // strains by sqrt(2 rho 5 / E) = 58 %.
    EXPECT_LT(elastic, 0.09f);
    EXPECT_GT(most, 2.0f * elastic);
    // Flow stops at `yield` below the largest strain.
    EXPECT_GT(plastic, 0.15f) << "of " << plasticMost;
}

TEST(SoftBody, AStretchedBarNarrowsByItsPoissonRatio)
{
    // Thin enough that its weight hardly matters; the floor is smooth, so that the sides are free. If it sags by s on
    // average, it widens by nu s.
    const World world = softBox({5, LAYERS, 5}, jelly(1e5f, 0.3f), stepped(4, 4), true, 0.5f * LAYERS * DIAMETER);
    Solver solver(gpu(), world);
    run(solver, world, 2.5);
    const ParticleState state = solver.readParticles();
    const double shorter = (REST_HEIGHT - heightOf(world, state)) / REST_HEIGHT;
    double inertia = 0.0, inertiaAtRest = 0.0, middle = 0.0;
    for (const Vector3f& x : state.positions) middle += x.x() / static_cast<double>(state.positions.size());
    for (size_t i = 0; i < world.particles.size(); ++i) {
        inertia += std::pow(state.positions[i].x() - middle, 2);
        inertiaAtRest += std::pow(world.particles[i].position.x(), 2);
    }
    const double wider = std::sqrt(inertia / inertiaAtRest) - 1.0;
    EXPECT_NEAR(wider / shorter, 0.3, 0.05);
}

}  // namespace

}  // namespace knuckle::test
