#include <cmath>

#include "physics_test.h"

namespace knuckle::test {

namespace {

/// A soft box on its own, standing on a floor of no friction where asked for.
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

/// Mean height of the particles that were highest at the start less that of the lowest [m].
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

/// How much lower a standing column of nine layers becomes under its weight [m].
double sag(float stiffness, const Settings& settings, float poissonRatio = 0.0f)
{
    const World world = softBox({5, LAYERS, 5}, jelly(stiffness, poissonRatio), settings, true, 0.5f * LAYERS * DIAMETER);
    Solver solver(gpu(), world);
    run(solver, world, 2.5);
    return REST_HEIGHT - heightOf(world, solver.readParticles());
}

TEST(SoftBody, PROBE)
{
    for (float e : {2e4f, 1e5f, 3e5f, 1e6f})
        for (auto [s, i] : {std::pair{4u, 2u}, {4u, 1u}, {4u, 4u}, {12u, 2u}, {12u, 4u}}) {
            const double law = 1000 * 9.81 * 0.9 * 0.8 / (2 * e) * 8 / 9;
            { const double got = sag(e, stepped(s, i)); printf("E %g substeps %u iterations %u: sag %.5f law %.5f ratio %.3f\n", e, s, i, got, law,
                   got / law); }
        }
    printf("nu 0.3: %.5f\n", sag(2e4f, stepped(4, 2), 0.3f));
    for (float e : {5e3f, 5e4f, 1e6f}) {
        const World world = softBox({5, 5, 5}, jelly(e, 0.3f), weightless(), false, 1, {0.3f, 0.1f, -0.2f},
                                    {0.5f, 1.0f, 2.0f});
        Solver solver(gpu(), world);
        const Totals before = totals(world, solver.readParticles());
        run(solver, world, 5.0);
        const Totals after = totals(world, solver.readParticles());
        printf("E %g: momentum %g of %g, angular %g of %g\n", e, (after.momentum - before.momentum).norm(), before.speedSum,
               (after.angularMomentum - before.angularMomentum).norm(), before.angularMomentum.norm());
    }
    for (float creep : {0.0f}) {
        Elasticity elasticity = jelly(3e4f, 0.3f);
        elasticity.creep = creep;
        const World world = softBox({5, 5, 5}, elasticity, {}, true, 1.25f);
        Solver solver(gpu(), world);
        float worst = 0;
        for (int k = 0; k < 40; ++k) {
            run(solver, world, 0.1);
            const Measures m = solver.measure();
            worst = std::max(worst, m.meanSoftStrain);
            if (k % 5 == 4) printf("creep %g t %.1f strain %.4f worst %.4f volume %.4f height %.4f\n", creep, 0.1 * (k + 1), m.meanSoftStrain, m.worstSoftStrain, m.softVolumeError, heightOf(world, solver.readParticles()));
        }
        printf("most %.4f\n", worst);
    }
}

}  // namespace

}  // namespace knuckle::test
