#include <algorithm>
#include <bit>
#include <cmath>

#include "shared/fluid_constants.h"
#include "tests/solver/fluid/fluid_cover.h"

namespace knuckle::test {
namespace {

/// Rounding of sums of some fifty neighbours in single precision, and of multipliers that are half a float.
constexpr double ROUNDING = 2e-5, HALF_ROUNDING = 2.5e-3;

/// Also with a grid that wraps too early, whose lists contain particles far away.
class FluidDensity : public testing::TestWithParam<bool> {
protected:
    FluidDensity()
    {
        fixture.wrap(GetParam());
        fixture.findNeighbours();
        std::vector<uint32_t> colliders(fixture.count(), 0);
        for (uint32_t i = fixture.solidCount(); i < fixture.count(); ++i) colliders[i] = 3;
        FluidStage& f = *fixture.stages.fluids;
        fill(f.slotColliders, fixture.inSlots(colliders));
        Random random(47);
        for (uint32_t i = 0; i < fixture.count(); ++i) {
            moves.push_back(random.inCube(0.004f));
            isNew.push_back(fixture.isFluid(i) && i % 13 == 0);
            gpu::vec4 last = packed(moves.back());
            last.w = !fixture.isFluid(i) ? -fixture.packedTurn(i).y : isNew.back() ? 1.0f : 0.0f;
            lasts.push_back(last);
            pasts.push_back({0, 0, 0, random.between(-0.02f, 0.3f)});
            // Drawn out along x: two elements of the trace, of which one is stored.
            const float rate = parameters().evenSmoothing,
                        flow = random.between(0.0f, 0.01f / parameters().substepTime);
            gradients.push_back({std::bit_cast<uint32_t>(rate * flow) & 0xffff0000u, 0, 0, 0});
            flows.push_back(std::sqrt(2.0) * double(std::bit_cast<float>(gradients.back().x) / rate));
        }
        fill(f.slotGradients, fixture.inSlots(gradients));
        velocities = randomVectors(fixture.count(), 2.0f, 49);
        fill(f.slotVelocities, fixture.inSlots(velocities));
        fill(f.slotMoves, fixture.inSlots(lasts));
        fill(f.fluidPasts, pasts);
        fixture.forSlots("fluid/pressure/fluid_shape");
        const auto shapes = f.slotShapes.download();
        for (uint32_t k = 0; k < fixture.count(); ++k) {
            const gpu::vec4 s = shapes[2 * k], u = shapes[2 * k + 1];
            Matrix3d even;
            even << s.x, s.y, s.z, s.y, u.x, u.y, s.z, u.y, u.z;
            evens.push_back(even);
        }
        evens = fixture.byParticle(evens);
        fixture.forSlots("fluid/pressure/fluid_density", {{"EMITTERS", "1"}});
        const auto found = f.slotPressures.download();
        for (uint32_t k = 0; k < fixture.count(); ++k) pressures.push_back(pressureOf(found[2 * k], found[2 * k + 1]));
        pressures = fixture.byParticle(pressures);
        walls = fixture.byParticle(f.slotWalls.download());
        covers = fixture.byParticle(f.slotCovers.download());
        solids = fixture.byParticle(f.slotSolids.download());
        after = f.fluidPasts.download();
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
            cover.moment -= fixture.slope(r.norm()) / r.norm() * r * r.transpose();
        }
        return cover;
    }
    double spacing() const { return parameters().fluidSpacing; }
    static double weight(double r, double reach) { return std::pow(std::max(1.0 - r / reach, 0.0), 2); }
    /// Squares: by how much the slopes of each exceed that of all, as far as solids lie on all sides (between).
    Cover bySolids(uint32_t i, double& weights, double& between, Vector3d& move) const
    {
        Cover cover;
        Vector3d way = Vector3d::Zero();
        weights = 0.0;
        move.setZero();
        for (uint32_t j : fixture.near(i, false, parameters().fluidListReach)) {
            const Vector3d r = fixture.place(i) - fixture.place(j);
            const double w = weight(r.norm(), parameters().fluidListReach);
            const Cover cell = cellCover(fixture, i, j);
            cover.share += cell.share;
            cover.slope += cell.slope;
            cover.squares += cell.slope.squaredNorm();
            cover.moment += cell.moment;
            move += w * moves[j].cast<double>();
            way += w * r.normalized();
            weights += w;
        }
        const double u = std::clamp((way.norm() / std::max(weights, 1e-20) - 0.3) / 0.3, 0.0, 1.0);
        between = 1.0 - u * u * (3.0 - 2.0 * u);
        cover.squares = std::max(cover.squares - cover.slope.squaredNorm(), 0.0) * between;
        move /= std::max(weights, 1e-20);
        return cover;
    }
    /// What two sides of a gap lack, as physics.md says.
    double gapGain(double one, double other) const
    {
        const double reach = parameters().fluidReach;
        const auto distance = [&](double share) { return reach * std::max(1.0 - std::pow(2.0 * share, 0.27), 0.0); };
        return 1.0 / std::max(1.0 - 2.0 * behind(distance(one) + distance(other), reach), 0.25);
    }
    /// An evened multiplier along a slope, or its mean where that vanishes.
    double evenAcross(const Matrix3d& even, const Vector3d& slope) const
    {
        const double least = 0.02 / std::pow(parameters().fluidReach, 2);
        return (slope.dot(even * slope) + least * even.trace() / 3.0) / (slope.squaredNorm() + least);
    }
    double gain(const Cover& wall, const Cover& solid, double between) const
    {
        const double among = 1.0 + between * (gapGain(0.5 * solid.share, 0.5 * solid.share) - 1.0);
        const double sizes = wall.slope.norm() * solid.slope.norm(), facing = -wall.slope.dot(solid.slope);
        if (facing <= 0.0) return among;
        return among * (1.0 + facing / std::max(sizes, 1e-12) * (gapGain(wall.share, solid.share) - 1.0));
    }
    /// The plane below and the one at the side, at right angles: their common part counts once.
    Cover byWalls(uint32_t i) const
    {
        const auto share = [&](double z) { return wallShare(parameters(), z); };
        const double below = fixture.place(i).y() + 0.25, beside = 0.25 - fixture.place(i).x();
        const double a = share(below), b = share(beside);
        const double bySide = FluidFixture::derivative(share, beside), byFloor = FluidFixture::derivative(share, below);
        // The floor comes first: of what the wall at the side covers, it leaves 1 - a.
        const Vector3d lean(-(1.0 - a) * std::max(beside, 0.0) * bySide, -std::max(below, 0.0) * byFloor, 0.0);
        return {a + b - a * b, 0.0, Vector3d(-(1.0 - a) * bySide, (1.0 - b) * byFloor, 0.0), lean.asDiagonal()};
    }
    /// A multiplier's matrix [kg m2].
    Matrix3d pressureOf(const gpu::uvec4& a, const gpu::uvec4& b) const
    {
        const auto word = [](uint32_t bits) { return std::bit_cast<float>(bits); };
        const float xy = word(a.w & 0xffff0000u), xz = word(a.w << 16), yz = word(b.w);
        Eigen::Matrix3f m;
        m << word(b.x), xy, xz, xy, word(b.y), yz, xz, yz, word(b.z);
        return 1000.0 / 256.0 * std::pow(spacing(), 3) / (100.0 * parameters().fluidSoftness) * m.cast<double>();
    }

    FluidFixture fixture;
    std::vector<Vector3f> moves;
    std::vector<bool> isNew;
    std::vector<gpu::uvec4> gradients;
    std::vector<double> flows;  ///< [1/s]
    std::vector<gpu::vec4> velocities, lasts, pasts, walls, covers, solids, after;
    std::vector<Matrix3d> evens, pressures;
};

/// As fluid_shape has it: near 1 where few particles are in a line or a plane.
Matrix3d boundedInverse(const Matrix3d& moment)
{
    constexpr double LEAST_DETERMINANT = 0.01, MOST_UNEVEN = 4.0;
    if (moment.determinant() < LEAST_DETERMINANT) return Matrix3d::Identity();
    const Matrix3d beyond = moment.inverse() - Matrix3d::Identity();
    return Matrix3d::Identity() + std::min(1.0, MOST_UNEVEN / beyond.norm()) * beyond;
}

TEST_P(FluidDensity, ShapesAreThoseOfDoublePrecision)
{
    uint32_t count = 0;
    for (uint32_t i = fixture.solidCount(); i < fixture.count(); ++i) {
        double weights = 0.0, between = 0.0;
        Vector3d move;
        const Cover fluid = byFluid(i), solid = bySolids(i, weights, between, move), wall = byWalls(i);
        const double covered = solid.share + wall.share, rest = std::max(1.0 - fluid.share - covered, 0.0);
        const Matrix3d moment = fluid.moment + solid.moment + wall.moment + (covered + rest) * Matrix3d::Identity();
        const double beside = std::clamp(solid.share / 0.05, 0.0, 1.0), blend = beside * beside * (3.0 - 2.0 * beside);
        const double part = FLUID_EVENNESS + (1.0 - FLUID_EVENNESS) * blend;
        const Matrix3d wanted = (1.0 - part) * Matrix3d::Identity() + part * boundedInverse(moment);
        ASSERT_LT((evens[i] - wanted).norm(), 2e-3 * wanted.norm()) << i;
        ++count;
    }
    EXPECT_GT(count, 300u);
}

TEST_P(FluidDensity, SharesSlopesAndMultipliersAreThoseOfDoublePrecision)
{
    const double epsilon = parameters().fluidSoftness;
    uint32_t pressed = 0, free = 0, loose = 0, besideNew = 0, besideSolids = 0, besideWalls = 0, inGap = 0, flowing = 0;
    for (uint32_t i = fixture.solidCount(); i < fixture.count(); ++i) {
        SCOPED_TRACE(i);
        double weights = 0.0, between = 0.0;
        Vector3d solidMove;
        const Cover fluid = byFluid(i);
        Cover solid = bySolids(i, weights, between, solidMove), wall = byWalls(i);
        const double more = gain(wall, solid, between);
        wall.slope *= more;
        solid.slope *= more;
        inGap += more > 1.1;
        const double share = fluid.share + solid.share + wall.share;
        ASSERT_NEAR(covers[i].w, share, ROUNDING * (1.0 + share));
        const double size = std::sqrt(fluid.squares) + 10.0;
        ASSERT_LT((vec3(walls[i]).cast<double>() - wall.slope).norm(), ROUNDING * size);
        ASSERT_NEAR(solids[i].w * weights, weights > 0.0 ? 1.0 : 0.0, ROUNDING);
        besideSolids += solid.share > 0.01;
        besideWalls += wall.share > 0.01;
        ASSERT_LT((vec3(solids[i]).cast<double>() - solid.slope).norm(), 1e-3 * (size + solid.slope.norm()));
        // What moves make of the compression that was.
        const double bySolids = evenAcross(evens[i], solid.slope);
        double nearer = 2.0 * moves[i].cast<double>().dot(evens[i] * wall.slope) +
                        2.0 * bySolids * (moves[i].cast<double>() - solidMove).dot(solid.slope);
        double added = 0.0;
        for (uint32_t j : fixture.fluidNear(i)) {
            const Vector3d r = fixture.place(i) - fixture.place(j);
            if (isNew[j]) added += fixture.share(r.norm());
            else
                nearer +=
                    (evens[i] * fixture.slope(r.norm()) * r.normalized()).dot((moves[i] - moves[j]).cast<double>());
        }
        const auto bounded = [](double c) {
            return std::clamp(c, double(LEAST_FLUID_ERROR), double(MOST_FLUID_ERROR));
        };
        const double excess = bounded(share - 1.0), carried = bounded(pasts[i].w + nearer);
        const double crowded = std::max(carried, std::min(carried + added, excess));
        const bool anew = isNew[i] || share < FLUID_LOOSE;
        const double flow = std::max(flows[i] - double(parameters().quietSpeed) / spacing(), 0.0),
                     byFlow = FLUID_FLOW_MIXING * parameters().substepTime * flow;
        const double mixed = std::min<double>(FLUID_MIXING + byFlow, MOST_FLUID_MIXING);
        flowing += flow > 0.0 && mixed < MOST_FLUID_MIXING;
        const double compression = anew ? excess : crowded + mixed * (excess - crowded);
        ASSERT_NEAR(after[i].w, compression, 1e-3);
        ASSERT_EQ(vec3(after[i]), vec3(fixture.places[i]));
        const Vector3d all = fluid.slope + wall.slope + solid.slope;
        const double under = all.squaredNorm() + fluid.squares + solid.squares + epsilon;
        const Matrix3d lambda = -FLUID_RELAXATION * std::max(double(after[i].w), 0.0) / under * fixture.mass(i) *
                                evens[i];
        ASSERT_LT((pressures[i] - lambda).norm(), HALF_ROUNDING * lambda.norm() + ROUNDING / under * fixture.mass(i));
        ++(compression > 0.0 ? pressed : free), loose += anew;
        besideNew += crowded > carried;
    }
    for (uint32_t number : {pressed, free, loose, besideNew, besideSolids, besideWalls, inGap, flowing})
        EXPECT_GT(number, 20u);
}

TEST_P(FluidDensity, NotesTheFastestSolidNearby)
{
    uint32_t none = 0;
    for (uint32_t i = fixture.solidCount(); i < fixture.count(); ++i) {
        float fastest = -1.0f;
        for (uint32_t j : fixture.near(i, false, parameters().fluidListReach))
            fastest = std::max(fastest, vec3(velocities[j]).norm());
        ASSERT_NEAR(covers[i].z, fastest, 1e-5) << i;
        none += fastest < 0.0f;
    }
    EXPECT_GT(none, 10u);
}

TEST_P(FluidDensity, SolidParticlesHaveNoPressure)
{
    for (uint32_t i = 0; i < fixture.solidCount(); ++i) ASSERT_EQ(pressures[i], Matrix3d::Zero()) << i;
}

TEST_P(FluidDensity, SolidsAreGivenWhatTheyGive)
{
    // fluid_pressure notes what solids give a fluid particle; fluid_solid_coupling returns that, along them by weights
    // and across them by the slopes of what they cover.
    std::vector<gpu::vec4> given(fixture.count());
    Random random(48);
    for (uint32_t i = fixture.solidCount(); i < fixture.count(); ++i) {
        given[i] = packed(solids[i].w * random.inCube(1e-3f));
        given[i].w = random.between(0.0f, 1e-5f);
    }
    fill(fixture.stages.fluids->slotSolidImpulses, fixture.inSlots(given));
    fill(fixture.stages.bodies.particleImpulses, std::vector<gpu::vec4>(fixture.count()));
    fixture.forParticles("fluid/pressure/fluid_solid_coupling");
    const auto impulses = fixture.stages.bodies.particleImpulses.download();
    const auto places = fixture.stages.particles.particleRanks.download();
    std::vector<Vector3d> wanted(fixture.solidCount(), Vector3d::Zero());
    Vector3d sum = Vector3d::Zero(), got = sum;
    double size = 0.0;
    for (uint32_t i = fixture.solidCount(); i < fixture.count(); ++i) {
        const Vector3d along = vec3(given[i]).cast<double>();
        if (solids[i].w > 0.0f) sum += along / double(solids[i].w);
        for (uint32_t j : fixture.near(i, false, parameters().fluidListReach)) {
            const Vector3d across = given[i].w * cellCover(fixture, i, j).slope;
            const double share = weight((fixture.place(i) - fixture.place(j)).norm(), parameters().fluidListReach);
            wanted[j] -= share * along + across;
            sum += across;
            size += (share * along + across).norm();
        }
    }
    uint32_t pushed = 0;
    for (uint32_t j = 0; j < fixture.solidCount(); ++j) {
        const Vector3d found = vec3(impulses[places[j].y]).cast<double>();
        got += found;
        pushed += found.norm() > 0.0;
        ASSERT_LT((found - wanted[j]).norm(), ROUNDING * (wanted[j].norm() + size / fixture.solidCount())) << j;
    }
    EXPECT_GT(pushed, 50u);
    EXPECT_LT((sum + got).norm(), ROUNDING * size);
}

INSTANTIATE_TEST_SUITE_P(Lattices, FluidDensity, testing::Bool(),
                         [](const auto& wrapped) { return wrapped.param ? "WrappedEarly" : "Wide"; });

}  // namespace
}  // namespace knuckle::test
