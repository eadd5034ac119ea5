#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/solver/solver_test.h"

namespace knuckle::test {

namespace {

/// Movers that have moved and turned at random since the substep began, from zero to too far to look ahead.
class SearchPosition : public testing::Test {
protected:
    explicit SearchPosition(const Settings& settings = {}) : fixture(mixedWorld(settings))
    {
        Random random(81);
        for (uint32_t m = 0; m < movers(); ++m) {
            centres.push_back(packed(random.inCube(0.4f)));
            rotations.push_back(packed(random.rotation()));
            const float way = m % 5 == 0 ? 0.0f : std::pow(10.0f, random.between(-4.0f, -1.5f));
            moves.push_back(packed(way * random.direction(), 2.0f));
            turns.push_back(packed(Quaternionf(Eigen::AngleAxisf(random.between(0, 0.2f), random.direction()))));
            reaches.push_back(m % 3 == 0 ? random.between(0.0f, 1.0f) * parameters().farReach : 0.0f);
        }
        // Loose particles do not turn.
        for (uint32_t m = parameters().bodyCount; m < movers(); ++m) rotations[m] = turns[m] = {0, 0, 0, 1};
        Stages& b = fixture.stages;
        fill(b.bodies.moverCentres, centres);
        fill(b.bodies.moverRotations, rotations);
        fill(b.bodies.moverMoves, moves);
        fill(b.bodies.moverRotationDeltas, turns);
        fill(b.search.moverReaches, reaches);
        fill(b.search.listCounts, std::vector<uint32_t>(b.search.listCounts.size(), 5));
        places = b.particles.particleRanks.download();
    }
    const gpu::StepParameters& parameters() const { return fixture.stages.parameters; }
    uint32_t movers() const { return fixture.stages.parameters.moverCount; }
    uint32_t particles() const { return fixture.stages.parameters.particleCount; }
    void findPlaces(const Defines& defines = {})
    {
        fixture.forMovers("search/search_centre", defines);
        fixture.forParticles("search/search_position", defines);
    }
    void setFastCount(uint32_t fast)
    {
        gpu::Counters counters = fixture.counters();
        counters.fastCount = fast;
        fixture.setCounters(counters);
    }
    /// How far the mover's centre is put ahead of its place now: its way in lookAhead substeps, at most three quarters
    /// of its margin.
    Vector3d ahead(uint32_t m, double drift) const
    {
        const Vector3d move = vec3(moves[m]).cast<double>();
        const double way = std::min<double>(parameters().lookAhead * move.norm(), 0.75 * drift);
        return move.norm() > 0.0 ? Vector3d(way * move.normalized()) : Vector3d(Vector3d::Zero());
    }
    /// @param reach whether movers use their reaches.
    void expectPlaces(bool reach)
    {
        const auto found = fixture.stages.search.searchPositions.download(),
                   offsets = fixture.stages.particles.restOffsets.download();
        const auto searchCentres = fixture.stages.search.searchCentres.download();
        const auto searchRotations = fixture.stages.search.searchRotations.download();
        const auto infos = fixture.stages.bodies.moverInfo.download();
        for (uint32_t i = 0; i < particles(); ++i) {
            const uint32_t m = places[i].x;
            const double drift = parameters().drift + (reach ? reaches[m] : 0.0f);
            const Quaternionf now = quaternion(turns[m]) * quaternion(rotations[m]);
            const Vector3d centre = vec3(centres[m]).cast<double>() + vec3(moves[m]).cast<double>() + ahead(m, drift);
            const Vector3d place = centre + now.cast<double>() * vec3(offsets[i]).cast<double>();
            ASSERT_LT((vec3(found[i]).cast<double>() - place).norm(), ROUNDING) << "particle " << i;
            ASSERT_LT((vec3(searchCentres[m]).cast<double>() - centre).norm(), ROUNDING) << "mover " << m;
            ASSERT_NEAR(searchCentres[m].w, drift, ROUNDING) << "mover " << m;
            ASSERT_LT(quaternion(searchRotations[m]).angularDistance(now), 2e-6f) << "mover " << m;
        }
        const auto states = fixture.stages.bodies.moverStates.download();
        EXPECT_TRUE(std::any_of(states.begin(), states.end(), [](uint32_t state) { return state == MOVER_FIXED; }));
    }
    std::vector<uint32_t> fastParticles() const
    {
        auto fast = fixture.stages.search.fastParticles.download();
        fast.resize(fixture.counters().fastListed);
        for (uint32_t& entry : fast) entry >>= 1;  // the lowest bit: whether its clip tells its place
        std::sort(fast.begin(), fast.end());
        return fast;
    }

    void expectReaches(float longer)
    {
        const auto found = fixture.stages.search.moverReaches.download();
        const auto infos = fixture.stages.bodies.moverInfo.download();
        const auto moments = fixture.stages.bodies.bodyMoments.download();
        uint32_t fast = 0, later = 0, none = 0, most = 0;
        for (uint32_t m = 0; m < movers(); ++m) {
            const double radius = m < parameters().bodyCount ? moments[3 * m].w : 0.0;
            // A way of 1.75 times the distance of the place ahead of its start, and a turn, which is not looked ahead
            // of.
            const double way = vec3(moves[m]).cast<double>().norm() / 1.75 +
                               2.0 * quaternion(turns[m]).cast<double>().vec().norm() * radius;
            const double missing = longer * parameters().horizon * way - parameters().drift;
            ASSERT_NEAR(found[m], std::clamp<double>(missing, 0.0, parameters().farReach), longer * ROUNDING) << m;
            ASSERT_GE(found[m], 0.0f);
            ASSERT_LE(found[m], parameters().farReach);
            if (found[m] > 0.0f) fast += infos[m].rankCount;
            if (FAR_SIGHT * parameters().horizon * way > parameters().drift) later += infos[m].rankCount;
            ++(found[m] == 0.0f ? none : most);
        }
        EXPECT_EQ(fixture.counters().fastCount, fast);
        EXPECT_EQ(fixture.counters().fastLater, later);
        for (uint32_t number : {none, most}) EXPECT_GT(number, 20u);
    }

    /// Places up to a metre: 16 roundings of 2^-24 of it.
    static constexpr double ROUNDING = 1e-6;
    KernelFixture fixture;
    std::vector<gpu::vec4> centres, rotations, moves, turns;
    std::vector<float> reaches;
    std::vector<gpu::uvec2> places;
};

TEST_F(SearchPosition, LiesAheadOnTheWayByUpToThreeQuartersOfTheDrift)
{
    setFastCount(parameters().fastLimit);
    findPlaces();
    expectPlaces(true);
    uint32_t bounded = 0, free = 0;
    for (uint32_t m = 0; m < movers(); ++m) {
        const float way = parameters().lookAhead * vec3(moves[m]).norm();
        bounded += way > 0.75f * (parameters().drift + reaches[m]);
        free += way > 0.0f && way < 0.75f * parameters().drift;
    }
    EXPECT_GT(bounded, 50u);
    EXPECT_GT(free, 50u);
}

TEST_F(SearchPosition, ParticlesOfMoversThatReachFurtherAreListed)
{
    setFastCount(parameters().fastLimit);
    findPlaces();
    std::vector<uint32_t> wanted;
    for (uint32_t i = 0; i < particles(); ++i)
        if (reaches[places[i].x] > 0.0f) wanted.push_back(i);
    ASSERT_GT(wanted.size(), 100u);
    EXPECT_EQ(fastParticles(), wanted);
}

TEST_F(SearchPosition, NobodyReachesFurtherWhereTooManyWouldHaveTo)
{
    setFastCount(parameters().fastLimit + 1);
    findPlaces();
    expectPlaces(false);
    EXPECT_TRUE(fastParticles().empty());
}

TEST_F(SearchPosition, TheGridAgreesOnWhoIsFastHoweverLittleAMoverReaches)
{
    // contact_find leaves the particles that grid_order calls fast to contact_find_far: none may belong to both or
    // neither.
    for (size_t m = 0; m < reaches.size(); ++m) reaches[m] = std::pow(10.0f, -static_cast<float>(m % 20));
    fill(fixture.stages.search.moverReaches, reaches);
    setFastCount(0);
    findPlaces();
    fixture.fillGrid({});
    std::vector<uint32_t> fast;
    const auto infos = fixture.stages.search.sortedParticles.download();
    for (uint32_t k = 0; k < particles(); ++k)
        if ((infos[k] & 1u) != 0) fast.push_back(infos[k] >> 1);
    std::sort(fast.begin(), fast.end());
    EXPECT_GT(fast.size(), 100u);
    EXPECT_LT(fast.size(), 900u) << "the least reaches are lost in the sum with the drift";
    EXPECT_EQ(fastParticles(), fast);
}

TEST_F(SearchPosition, NoParticleIsReferredToYet)
{
    findPlaces();
    const auto counts = fixture.stages.search.listCounts.download();
    for (uint32_t k = 0; k < counts.size(); ++k) ASSERT_EQ(counts[k], k / particles() == 1 ? 0u : 5u) << "count " << k;
}

class SearchPositionByThePaper : public SearchPosition {
protected:
    SearchPositionByThePaper() : SearchPosition(byThePaper()) {}
};

TEST_F(SearchPositionByThePaper, ThePapersParticlesAreWhereTheyArePredictedAndItsBodiesAsTheyAreTurned)
{
    const auto starts = randomVectors(particles(), 0.5f, 82), predicted = randomVectors(particles(), 0.01f, 83);
    fill(fixture.stages.particles.positions, starts);
    fill(fixture.stages.paper->predicted, predicted);
    findPlaces({{"FROM_POSITIONS", "1"}});
    const auto found = fixture.stages.search.searchPositions.download(),
               turned = fixture.stages.search.searchRotations.download();
    for (uint32_t i = 0; i < particles(); ++i) {
        ASSERT_EQ(vec3(found[i]), vec3(starts[i]) + vec3(predicted[i]));
        const uint32_t mover = places[i].x;
        ASSERT_EQ(quaternion(turned[mover]).coeffs(), quaternion(rotations[mover]).coeffs());
    }
}

TEST_F(SearchPosition, MoversReachAsFarAsTheirWayWillLeadThemBeyondTheDriftAndForLongerWhereFewAreFast)
{
    moves[1] = packed({1e30f, 0, 0});
    fill(fixture.stages.bodies.moverMoves, moves);
    for (uint32_t calm : {0u, 1u}) {
        SCOPED_TRACE(calm);
        gpu::Counters counters = fixture.counters();
        counters.farSighted = calm;
        counters.fastCount = counters.fastLater = 0;
        fixture.setCounters(counters);
        fixture.forMovers("search/mover_reach");
        expectReaches(calm == 1 ? FAR_SIGHT : 1.0f);
    }
}

}  // namespace

}  // namespace knuckle::test
