#include "sim/solver/layout/soft_pace.h"

#include <cmath>

#include "tests/solver/body/mover_fixture.h"

namespace knuckle::test {

namespace {

/// A cube of one cluster.
World cube(float stiffness, float damping = 0.005f, float poissonRatio = 0.3f)
{
    Settings settings;
    settings.substeps = 4;
    WorldBuilder builder(DIAMETER / 2, settings);
    Material material;
    material.density = 1000.0f;
    material.elasticity.stiffness = stiffness;
    material.elasticity.damping = damping;
    material.elasticity.poissonRatio = poissonRatio;
    builder.addMaterial(material);
    builder.beginObject("cube");
    builder.addSoftBody("cube", boxLattice({3, 3, 3}, DIAMETER), 0);
    builder.endObject();
    return builder.build();
}

TEST(SoftPace, TheSteepestPullIsThatOfASwellingCube)
{
    // Swelling: E / (1 - 2 nu) / (density x^2), where the mean square x^2 along an axis is 2/3 of d^2. A bend within:
    // E / density (1 + d^2 / (12 x^2)) / x^2, which is more where nu is 0. Found to 3 %, and a margin of 10 %.
    const double square = 2.0 / 3.0 * std::pow(double(DIAMETER), 2), unit = 2e4 / 1000.0 / square;
    for (float nu : {0.0f, 0.3f, 0.45f}) {
        SCOPED_TRACE(nu);
        const World world = cube(2e4f, 0.005f, nu);
        const double wanted = unit * std::max(1.0 / (1.0 - 2.0 * double(nu)), 1.0 + 1.0 / 8.0);
        const double found = softPace(world, world.softBodies[0]).steepest;
        EXPECT_GT(found, 1.06 * wanted);
        EXPECT_LT(found, 1.101 * wanted);
    }
}

TEST(SoftPace, IterationsGrowAsTheRootOfTheStiffnessUpToTheMost)
{
    const auto pace = [](float stiffness, float damping = 0.005f) {
        const World world = cube(stiffness, damping);
        return softPace(world, world.softBodies[0]);
    };
    EXPECT_EQ(pace(2e4f).iterations, 2u);
    const uint32_t some = pace(1.2e6f).iterations, twice = pace(4.8e6f).iterations;
    EXPECT_GT(some, 2u);
    EXPECT_NEAR(twice, 2.0 * some, 1.0);
    EXPECT_EQ(pace(4e6f).stiffness, 4e6f);
    EXPECT_EQ(pace(4e6f).damping, 0.005f);
    // Beyond what they follow, damping goes first.
    const double h = 1.0 / 240.0;
    const SoftPace damped = pace(2e5f, 1.0f), stiff = pace(1e9f, 1.0f);
    EXPECT_EQ(damped.iterations, MOST_SOFT_ITERATIONS);
    EXPECT_EQ(damped.stiffness, 2e5f);
    EXPECT_GT(damped.damping, 4.0 * h);
    EXPECT_NEAR(stiff.damping, 4.0 * h, 1e-6);
    EXPECT_LT(stiff.stiffness, 1e7f);
    for (const SoftPace& limited : {damped, stiff})
        EXPECT_NEAR(h * (h + double(limited.damping)) * limited.steepest, Chebyshev(MOST_SOFT_ITERATIONS).followed(),
                    0.01);
}

TEST(SoftPace, ChebyshevsIterationsLeaveNothingOfSmoothStrainsAndLittleOfAny)
{
    // In the form of products, whose factors are 1 - eigenvalue / root.
    for (uint32_t n : {1u, 2u, 4u, 5u, 16u}) {
        SCOPED_TRACE(n);
        const Chebyshev c(n);
        const double most = 1.0 + c.followed(), least = c.least * most;
        const auto left = [&](double eigenvalue) {
            double product = 1.0;
            for (uint32_t k = 0; k < n; ++k)
                product *= 1.0 -
                           eigenvalue / (0.5 * (most + least) - 0.5 * (most - least) * std::cos(M_PI * (k + 0.5) / n));
            return std::abs(product);
        };
        EXPECT_NEAR(left(1.0), 0.0, 1e-6);
        double worst = 0.0;
        for (int k = 0; k <= 1000; ++k) worst = std::max(worst, left(1.0 + (most - 1.0) * k / 1000.0));
        EXPECT_LE(worst, (n <= 5 ? 0.3 : 0.15) + 1e-9);
    }
}

}  // namespace

}  // namespace knuckle::test
