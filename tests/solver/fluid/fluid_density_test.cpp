#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/solver/fluid/fluid_fixture.h"

namespace knuckle::test {

namespace {

/// Rounding of sums of some fifty neighbours in single precision.
constexpr double ROUNDING = 2e-5;

/// The share of the kernel behind a plane at z (physics.md).
double wallFraction(double z, double reach)
{
    const double t = std::clamp(1.0 - z / reach, 0.0, 1.0);
    return 3.5 * std::pow(t, 6) - 4.5 * std::pow(t, 7) + 1.5 * std::pow(t, 8);
}

/// Cover of a particle's kernel: the share, its slope, and the sum of squares of slopes.
struct Cover {
    double share = 0.0, squares = 0.0;
    Vector3d slope = Vector3d::Zero();
};

/// Also with a grid that wraps too early, whose lists contain particles far away.
class FluidDensity : public testing::TestWithParam<bool> {
protected:
    FluidDensity()
    {
        fixture.wrap(GetParam());
        fixture.findNeighbours();
        std::vector<uint32_t> colliders(fixture.count(), 0);
        for (uint32_t i = fixture.solidCount(); i < fixture.count(); ++i) colliders[i] = 3;
        fill(fixture.stages.fluids->slotColliders, fixture.inSlots(colliders));
        fixture.forSlots("fluid/fluid_density");
        pressures = fixture.byParticle(fixture.stages.fluids->slotPressures.download());
        walls = fixture.byParticle(fixture.stages.fluids->slotWalls.download());
        solids = fixture.byParticle(fixture.stages.fluids->slotSolids.download());
    }
    const gpu::StepParameters& parameters() const { return fixture.parameters(); }
    Cover byFluid(uint32_t i) const
    {
        Cover cover{fixture.share(0.0)};
        for (uint32_t j : fixture.fluidNear(i)) {
            const Vector3d r = fixture.place(i) - fixture.place(j);
            cover.share += fixture.share(r.norm());
            cover.slope += fixture.slope(r.norm()) * r.normalized();
            cover.squares += std::pow(fixture.slope(r.norm()), 2);
        }
        return cover;
    }
    /// d^2 / (2 pi r) times the growth of a wall's share at r - d / 2; below d / 2 that of d / 2; fading to nothing
    /// within the last fifth of a diameter of the lists' reach.
    double solidFraction(double r) const
    {
        const double d = parameters().diameter, far = std::max(r, 0.25 * d), reach = parameters().fluidReach;
        const double u = std::clamp((parameters().fluidListReach - r) / (0.2 * d), 0.0, 1.0);
        const double slope = FluidFixture::derivative([&](double z) { return wallFraction(z, reach); },
                                                      std::max(far - 0.5 * d, 2e-6));
        return -parameters().solidCover * d * d / (2.0 * std::numbers::pi * far) * slope * u * u * (3.0 - 2.0 * u);
    }
    static double weight(double r, double reach) { return std::pow(std::max(1.0 - r / reach, 0.0), 2); }
    /// The slope only across the surface that the nearby particles form together, if they lie on one side; squares: by
    /// how much the slopes of each exceed that.
    Cover bySolids(uint32_t i, double& weights) const
    {
        Cover cover;
        Vector3d way(0, 1e-12, 0);
        weights = 0.0;
        for (uint32_t j : fixture.near(i, false, parameters().fluidListReach)) {
            const Vector3d r = fixture.place(i) - fixture.place(j);
            const double far = r.norm(), w = weight(far, parameters().fluidListReach);
            cover.share += solidFraction(far);
            const double slope = FluidFixture::derivative([&](double x) { return solidFraction(x); }, far);
            cover.slope += slope * r.normalized();
            cover.squares += slope * slope;
            // Where the share no longer grows, the slope continues.
            usual = usual && far > 0.25 * parameters().diameter;
            way += w * r.normalized();
            weights += w;
        }
        const double u = std::clamp((way.norm() / std::max(weights, 1e-20) - 0.3) / 0.3, 0.0, 1.0);
        const Vector3d across = way.normalized().dot(cover.slope) * way.normalized();
        cover.slope += u * u * (3.0 - 2.0 * u) * (across - cover.slope);
        cover.squares = std::max(cover.squares - cover.slope.squaredNorm(), 0.0);
        return cover;
    }
    /// The plane below and the one at the side, at right angles: their common part counts once.
    Cover byWalls(uint32_t i) const
    {
        const double reach = parameters().fluidReach;
        const auto share = [&](double z) { return wallFraction(z, reach); };
        const double below = fixture.place(i).y() + 0.25, beside = 0.25 - fixture.place(i).x();
        const double a = share(below), b = share(beside);
        return {a + b - a * b, 0.0,
                Vector3d(-(1.0 - a) * FluidFixture::derivative(share, beside),
                         (1.0 - b) * FluidFixture::derivative(share, below), 0.0)};
    }

    FluidFixture fixture;
    std::vector<gpu::vec4> pressures, walls, solids;
    mutable bool usual = true;
};

TEST_P(FluidDensity, SharesSlopesAndMultipliersAreThoseOfDoublePrecision)
{
    const double epsilon = parameters().fluidSoftness;
    uint32_t pressed = 0, free = 0, besideSolids = 0, besideWalls = 0;
    for (uint32_t i = fixture.solidCount(); i < fixture.count(); ++i) {
        SCOPED_TRACE(i);
        double weights = 0.0;
        usual = true;
        const Cover fluid = byFluid(i), solid = bySolids(i, weights), wall = byWalls(i);
        const double share = fluid.share + solid.share + wall.share;
        ASSERT_NEAR(walls[i].w, share, ROUNDING * (1.0 + share));
        const double size = std::sqrt(fluid.squares) + 10.0;
        ASSERT_LT((vec3(walls[i]).cast<double>() - wall.slope).norm(), ROUNDING * size);
        ASSERT_NEAR(solids[i].w * weights, weights > 0.0 ? 1.0 : 0.0, ROUNDING);
        besideSolids += solid.share > 0.01;
        besideWalls += wall.share > 0.01;
        // Closer than a quarter of a diameter the slope is no longer that of the share.
        if (!usual) continue;
        ASSERT_LT((vec3(solids[i]).cast<double>() - solid.slope).norm(), 1e-3 * (size + solid.slope.norm()));
        const double tooMuch = std::clamp(share - 1.0, 0.0, double(MOST_FLUID_ERROR));
        const Vector3d all = fluid.slope + wall.slope + solid.slope;
        const double under = all.squaredNorm() + fluid.squares + solid.squares + epsilon;
        const double lambda = -FLUID_RELAXATION * tooMuch / under * fixture.mass(i);
        ASSERT_NEAR(pressures[i].w, lambda, 1e-3 * std::abs(lambda) + ROUNDING / under * fixture.mass(i));
        ++(tooMuch > 0.0 ? pressed : free);
    }
    for (uint32_t number : {pressed, free, besideSolids, besideWalls}) EXPECT_GT(number, 50u);
}

TEST_P(FluidDensity, SolidParticlesHaveNoPressure)
{
    for (uint32_t i = 0; i < fixture.solidCount(); ++i) ASSERT_EQ(pressures[i].w, 0.0f) << i;
}

TEST_P(FluidDensity, SolidsAreGivenWhatTheyGive)
{
    // fluid_pressure moves a fluid particle by lambda times solids' slope; fluid_solid_coupling returns that by
    // weights.
    fill(fixture.stages.bodies.particleImpulses, std::vector<gpu::vec4>(fixture.count()));
    fixture.forParticles("fluid/fluid_solid_coupling");
    const auto impulses = fixture.stages.bodies.particleImpulses.download();
    const auto places = fixture.stages.particles.particleRanks.download();
    std::vector<Vector3d> wanted(fixture.solidCount(), Vector3d::Zero());
    Vector3d given = Vector3d::Zero(), got = Vector3d::Zero();
    double size = 0.0;
    for (uint32_t i = fixture.solidCount(); i < fixture.count(); ++i) {
        const Vector3d impulse = double(pressures[i].w) * vec3(solids[i]).cast<double>();
        given += impulse;
        size += impulse.norm();
        for (uint32_t j : fixture.near(i, false, parameters().fluidListReach))
            wanted[j] -= weight((fixture.place(i) - fixture.place(j)).norm(), parameters().fluidListReach) *
                         double(solids[i].w) * impulse;
    }
    uint32_t pushed = 0;
    for (uint32_t j = 0; j < fixture.solidCount(); ++j) {
        const Vector3d found = vec3(impulses[places[j].y]).cast<double>();
        got += found;
        pushed += found.norm() > 0.0;
        ASSERT_LT((found - wanted[j]).norm(), ROUNDING * (wanted[j].norm() + size / fixture.solidCount())) << j;
    }
    EXPECT_GT(pushed, 50u);
    EXPECT_LT((given + got).norm(), ROUNDING * size);
}

INSTANTIATE_TEST_SUITE_P(Lattices, FluidDensity, testing::Bool(),
                         [](const auto& wrapped) { return wrapped.param ? "WrappedEarly" : "Wide"; });

}  // namespace

}  // namespace knuckle::test
