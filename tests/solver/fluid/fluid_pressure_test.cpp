#include <algorithm>
#include <bit>
#include <cmath>

#include "shared/fluid_constants.h"
#include "tests/solver/fluid/fluid_fixture.h"

namespace knuckle::test {

namespace {

constexpr double ROUNDING = 1e-5;
/// slot_covers.glsl
constexpr float NO_SOLID = -1.0f;

/// Two upper halves in a word.
uint32_t halves(float a, float b)
{
    return std::bit_cast<uint32_t>(upperHalf(a)) | std::bit_cast<uint32_t>(upperHalf(b)) >> 16;
}

/// Random pressures of particles up to twice too dense, uneven ones; starts are slightly off the places.
class FluidPressure : public testing::Test {
protected:
    FluidPressure()
    {
        fixture.findNeighbours();
        Random random(41);
        for (uint32_t i = 0; i < fixture.count(); ++i) {
            starts.push_back(packed(vec3(fixture.places[i]) + random.inCube(0.003f)));
            Eigen::Matrix3f lambda = Eigen::Matrix3f::Zero();
            if (fixture.isFluid(i)) {
                const Vector3f even = Vector3f::Ones() + random.inCube(0.3f), lean = random.inCube(0.2f);
                lambda << even.x(), lean.z(), lean.y(), lean.z(), even.y(), lean.x(), lean.y(), lean.x(), even.z();
                lambda *= -random.between(0.0f, 2e-4f) * float(fixture.mass(i)) / unit();
                for (const int k : {1, 2}) lambda(0, k) = lambda(k, 0) = upperHalf(lambda(k, 0));
            }
            pressures.push_back(lambda);
            covered.push_back(fixture.isFluid(i) ? random.between(0.0f, 0.5f) : 0.0f);
            gains.push_back(random.between(1.0f, 3.0f));
            walls.push_back(fixture.isFluid(i) ? random.vec4(3.0f) : gpu::vec4{});
            solids.push_back(fixture.isFluid(i) ? random.vec4(3.0f) : gpu::vec4{});
            before.push_back({1000, 0, 0, 0});  // so fast that no limit counts
        }
    }
    void push(float harder = 1.0f, const Defines& defines = {})
    {
        std::vector<gpu::uvec4> p;
        for (const uint32_t i : fixture.slotParticles) {
            const Eigen::Matrix3f m = harder * pressures[i];
            const auto word = [](float v) { return std::bit_cast<uint32_t>(v); };
            const gpu::vec4 at = fixture.places[i];
            p.push_back({word(at.x), word(at.y), word(at.z), halves(m(0, 1), m(0, 2))});
            p.push_back({word(m(0, 0)), word(m(1, 1)), word(m(2, 2)), word(m(1, 2))});
        }
        fill(fixture.stages.particles.positions, starts);
        fill(fixture.stages.particles.velocities, before);
        fill(fixture.stages.fluids->slotVelocities, fixture.inSlots(before));
        fill(fixture.stages.fluids->slotPressures, p);
        std::vector<gpu::vec4> covers;
        for (uint32_t i = 0; i < fixture.count(); ++i) {
            float fastest = NO_SOLID;
            for (uint32_t j : fixture.near(i, false, fixture.parameters().fluidListReach))
                fastest = std::max(fastest, vec3(before[j]).norm());
            covers.push_back({covered[i], gains[i], fastest, 0});
        }
        fill(fixture.stages.fluids->slotCovers, fixture.inSlots(covers));
        fill(fixture.stages.fluids->slotWalls, fixture.inSlots(walls));
        fill(fixture.stages.fluids->slotSolids, fixture.inSlots(solids));
        fixture.forSlots("fluid/pressure/fluid_pressure", defines);
        positions = fixture.stages.particles.positions.download();
    }
    void clearWalls()
    {
        walls = solids = std::vector<gpu::vec4>(fixture.count());
        covered.assign(fixture.count(), 0.0f);
    }
    Vector3d move(uint32_t i) const { return vec3(positions[i]).cast<double>() - fixture.place(i); }
    /// What pressures are stored in units of [kg m2].
    float unit() const
    {
        const gpu::StepParameters& p = fixture.parameters();
        return 1000.0f / 256.0f * std::pow(p.fluidSpacing, 3.0f) / (100.0f * p.fluidSoftness);
    }
    Matrix3d pressure(uint32_t i) const { return (unit() * pressures[i]).cast<double>(); }
    /// What pairs give along walls and solids counts more, as if fluid were behind them too.
    Vector3d alongWalls(uint32_t i, const Vector3d& pairs) const
    {
        const Vector3d normal = (vec3(walls[i]) + vec3(solids[i])).cast<double>().normalized();
        return FLUID_ALONG_WALLS * covered[i] / (1.0 - covered[i]) * (pairs - pairs.dot(normal) * normal);
    }
    Vector3d byWalls(uint32_t i) const { return 2.0 * pressure(i) * vec3(walls[i]).cast<double>(); }
    Vector3d bySolids(uint32_t i) const { return twiceAcross(i) * vec3(solids[i]).cast<double>(); }
    /// Twice its pressure across solids, or the mean of it where their slopes cancel [kg m2].
    double twiceAcross(uint32_t i) const
    {
        const Vector3d s = vec3(solids[i]).cast<double>();
        const double least = 0.02 / std::pow(fixture.parameters().fluidReach, 2);
        return 2.0 * (s.dot(pressure(i) * s) + least * pressure(i).trace() / 3.0) / (s.squaredNorm() + least);
    }
    Vector3d byPairs(uint32_t i) const
    {
        Vector3d sum = Vector3d::Zero();
        for (uint32_t j : fixture.fluidNear(i)) {
            const Vector3d r = fixture.place(i) - fixture.place(j);
            sum += (pressure(i) + pressure(j)) * fixture.slope(r.norm()) * r.normalized();
        }
        return sum;
    }
    /// Macklin and Mueller 2013, eq. 12, with masses, evened, and with fluid behind walls [kg m].
    Vector3d impulse(uint32_t i) const
    {
        const Vector3d pairs = byPairs(i);
        return pairs + alongWalls(i, pairs) + byWalls(i) + bySolids(i);
    }

    FluidFixture fixture;
    std::vector<gpu::vec4> starts, before, walls, solids, positions;
    std::vector<Eigen::Matrix3f> pressures;
    std::vector<float> covered, gains;
};

TEST_F(FluidPressure, MovesByThePressuresAround)
{
    push();
    const auto velocities = fixture.stages.particles.velocities.download();
    const double h = fixture.parameters().substepTime, most = 0.25 * fixture.parameters().fluidReach;
    double moved = 0.0;
    for (uint32_t i = fixture.solidCount(); i < fixture.count(); ++i) {
        const Vector3d wanted = impulse(i) / fixture.mass(i);
        ASSERT_LT(wanted.norm(), most);
        ASSERT_LT((move(i) - wanted).norm(), ROUNDING * (wanted.norm() + 0.01)) << i;
        const Vector3d v = (vec3(positions[i]) - vec3(starts[i])).cast<double>() * (fixture.parameters().damping / h);
        ASSERT_LT((vec3(velocities[i]).cast<double>() - v).norm(), ROUNDING * (v.norm() + 1.0)) << i;
        moved += wanted.norm();
    }
    EXPECT_GT(moved / fixture.parameters().fluidCount, 1e-3);
    EXPECT_EQ(fixture.counters().problems, 0u);
}

TEST_F(FluidPressure, NotesWhatSolidsGive)
{
    push();
    const auto given = fixture.byParticle(fixture.stages.fluids->slotSolidImpulses.download());
    for (uint32_t i = fixture.solidCount(); i < fixture.count(); ++i) {
        const double bySolids = vec3(solids[i]).norm(), share = bySolids / (bySolids + vec3(walls[i]).norm());
        const Vector3d wanted = solids[i].w * share * alongWalls(i, byPairs(i));
        const double across = gains[i] * twiceAcross(i);
        ASSERT_NEAR(given[i].w, across, 1e-4 * std::abs(across)) << i;
        ASSERT_LT((vec3(given[i]).cast<double>() - wanted).norm(), 1e-4 * (wanted.norm() + fixture.mass(i) * 1e-3))
            << i;
    }
}

TEST_F(FluidPressure, NotesHowFarParticlesWillHaveMoved)
{
    push();
    const auto moves = fixture.byParticle(fixture.stages.fluids->slotMoves.download());
    const auto next = fixture.byParticle(fixture.stages.fluids->slotPositions.download());
    for (uint32_t i = fixture.solidCount(); i < fixture.count(); ++i) {
        ASSERT_EQ(vec3(moves[i]), Eigen::Vector3f(vec3(next[i]) - vec3(fixture.places[i]))) << i;
        ASSERT_EQ(moves[i].w, 0.0f) << i;
    }
}

TEST_F(FluidPressure, ImpulsesOfPairsAddUpToNothing)
{
    clearWalls();
    fill(fixture.stages.fluids->fluidMaterials,
         std::vector<gpu::vec4>{{0, 0, 0, 0}, {0, 2e-5f, 0, 0}, {0, 1e-5f, 0, 0}});
    std::vector<uint32_t> materials;
    for (const Particle& p : fixture.world.particles) materials.push_back(p.material);
    fill(fixture.stages.fluids->slotMaterials, fixture.inSlots(materials));
    std::vector<gpu::vec4> without;
    for (const Defines& defines : {Defines{}, Defines{{"TENSION", "1"}}}) {
        push(1.0f, defines);
        Vector3d sum = Vector3d::Zero();
        double size = 0.0, changed = 0.0;
        for (uint32_t i = fixture.solidCount(); i < fixture.count(); ++i) {
            sum += fixture.mass(i) * move(i);
            size += fixture.mass(i) * move(i).norm();
            if (!without.empty()) changed += (vec3(positions[i]) - vec3(without[i])).norm();
        }
        EXPECT_LT(sum.norm(), ROUNDING * size);
        EXPECT_EQ(changed > 0.01 * size, !without.empty()) << "surface tension";
        without = positions;
    }
}

TEST_F(FluidPressure, NobodyIsPushedByMoreThanAQuarterOfTheReach)
{
    push(1000.0f);
    const double most = 0.25 * fixture.parameters().fluidReach;
    uint32_t held = 0;
    for (uint32_t i = fixture.solidCount(); i < fixture.count(); ++i) {
        const Vector3d wanted = 1000.0 * impulse(i) / fixture.mass(i);
        ASSERT_LT(move(i).norm(), most * 1.0001) << i;
        if (wanted.norm() < most) continue;
        ++held;
        ASSERT_LT((move(i).normalized() - wanted.normalized()).norm(), 4e-3) << i;  // halves
    }
    EXPECT_GT(held, 500u);
}

TEST_F(FluidPressure, AmongSolidsNobodyGetsMuchFasterThanTheyOrItWere)
{
    before = randomVectors(fixture.count(), 1.0f, 44);
    push(10.0f);
    const auto velocities = fixture.stages.particles.velocities.download();
    const double h = fixture.parameters().substepTime;
    uint32_t limited = 0, free = 0;
    for (uint32_t k = 0; k < fixture.count(); ++k) {
        const uint32_t i = fixture.slotParticles[k];
        if (!fixture.isFluid(i)) continue;
        const auto nearSolids = fixture.near(i, false, fixture.parameters().fluidListReach);
        double fastest = vec3(before[i]).norm();
        for (uint32_t j : nearSolids) fastest = std::max(fastest, double(vec3(before[j]).norm()));
        const Vector3d v = (vec3(positions[i]) - vec3(starts[i])).cast<double>() * (fixture.parameters().damping / h);
        const double most = !nearSolids.empty() ? fastest + MOST_SQUEEZE * h : INFINITY;
        const Vector3d wanted = v * std::min(1.0, most / v.norm());
        ASSERT_LT((vec3(velocities[i]).cast<double>() - wanted).norm(), ROUNDING * (v.norm() + 1.0)) << i;
        ++(v.norm() > most ? limited : free);
    }
    EXPECT_GT(limited, 100u);
    EXPECT_GT(free, 10u);
}

TEST_F(FluidPressure, NobodyIsLeftInAWall)
{
    clearWalls();
    std::vector<uint32_t> colliders(fixture.count(), 3);
    fill(fixture.stages.fluids->slotColliders, colliders);
    push();
    const float away = 0.25f * fixture.parameters().fluidSpacing;
    uint32_t shifted = 0;
    for (uint32_t i = fixture.solidCount(); i < fixture.count(); ++i) {
        ASSERT_GT(positions[i].y, -0.25f + away - 1e-6f);
        ASSERT_LT(positions[i].x, 0.25f - away + 1e-6f);
        shifted += positions[i].y < -0.25f + away + 1e-6f || positions[i].x > 0.25f - away - 1e-6f;
    }
    EXPECT_GT(shifted, 20u);
}

TEST_F(FluidPressure, SettlingMovesTheSameAndLeavesVelocities)
{
    push();
    const auto moved = positions;
    before = randomVectors(fixture.count(), 1.0f, 43);
    push(1.0f, {{"RELAX", "1"}});
    const auto kept = fixture.stages.particles.velocities.download();
    for (uint32_t i = 0; i < fixture.count(); ++i) {
        ASSERT_EQ(vec3(positions[i]), vec3(moved[i])) << i;
        ASSERT_EQ(vec3(kept[i]), vec3(before[i])) << i;
    }
}

TEST_F(FluidPressure, PredictsWhereTheNextSubstepEndsWithoutPressures)
{
    push();
    const auto velocities = fixture.stages.particles.velocities.download();
    const auto next = fixture.byParticle(fixture.stages.fluids->slotPositions.download());
    const float h = fixture.parameters().substepTime;
    const Vector3f fall = h * vec3(fixture.parameters().gravity);
    for (uint32_t i = fixture.solidCount(); i < fixture.count(); ++i) {
        const Vector3f wanted = vec3(positions[i]) + h * (vec3(velocities[i]) + fall);
        ASSERT_LT((vec3(next[i]) - wanted).norm(), 1e-6f) << i;
        ASSERT_NEAR(next[i].w, fixture.mass(i), ROUNDING * fixture.mass(i)) << i;
    }
}

TEST_F(FluidPressure, GoesOnALittleOnItsWayBeforeTheFirstStepWhereNoSolidIsNear)
{
    push(1.0f, {{"RELAX", "1"}});
    const auto next = fixture.byParticle(fixture.stages.fluids->slotPositions.download());
    const auto counts = fixture.byParticle(fixture.stages.fluids->slotCounts.download());
    float farthest = 0.0f;
    uint32_t among = 0;
    for (uint32_t i = fixture.solidCount(); i < fixture.count(); ++i) {
        Vector3f move = vec3(positions[i]) - vec3(starts[i]);
        move *= std::min(1.0f, 0.1f * fixture.parameters().fluidSpacing / move.norm());
        const bool isAmongSolids = counts[i].y > 0;
        if (isAmongSolids) move.setZero();
        among += isAmongSolids;
        farthest = std::max(farthest, move.norm());
        ASSERT_LT((vec3(next[i]) - vec3(positions[i]) - FLUID_MOMENTUM * move).norm(), 1e-6f) << i;
    }
    EXPECT_NEAR(farthest, 0.1f * fixture.parameters().fluidSpacing, 1e-6f);
    EXPECT_GT(among, 0u);
    EXPECT_LT(among, fixture.parameters().fluidCount);
    float largest = 0.0f;
    for (uint32_t i = fixture.solidCount(); i < fixture.count(); ++i)
        largest = std::max(largest, static_cast<float>(impulse(i).norm() / fixture.mass(i)));
    EXPECT_NEAR(std::bit_cast<float>(fixture.stages.fluids->fluidLargestPush.download()[0]), largest, 1e-4f * largest);
}

}  // namespace

}  // namespace knuckle::test
