#include <algorithm>
#include <cmath>

#include "sim/world/collider_distance.h"
#include "tests/solver/contact/collider_world.h"

namespace knuckle::test {

namespace {

/// Places up to half a metre and sums of three products: 16 roundings of 2^-24 of a metre, four times over for bodies.
constexpr float ROUNDING = 4e-6f;

/// Movers at random places, with their particles around them. The parameter: the number of colliders.
class ColliderFind : public testing::TestWithParam<uint32_t> {
protected:
    ColliderFind() : fixture(colliderWorld(GetParam()))
    {
        Random random(53);
        Stages& b = fixture.stages;
        const uint32_t movers = b.parameters.moverCount;
        std::vector<Quaternionf> turns;
        for (uint32_t m = 0; m < movers; ++m) {
            centres.push_back(packed(random.inCube(0.5f), b.parameters.drift));
            turns.push_back(random.rotation());
        }
        places = b.particles.particleRanks.download();
        const auto offsets = b.particles.restOffsets.download();
        for (uint32_t i = 0; i < places.size(); ++i) {
            const uint32_t m = places[i].x;
            found.push_back(packed(vec3(centres[m]) + turns[m] * vec3(offsets[i])));
        }
        fill(b.search.searchCentres, centres);
        fixture.setFound(found);
    }
    const gpu::StepParameters& parameters() const { return fixture.stages.parameters; }
    /// What the particles found.
    std::vector<std::vector<uint32_t>> download() const
    {
        const auto counts = fixture.stages.search.listCounts.download();
        const auto candidates = fixture.stages.search.candidates.download();
        const uint32_t count = parameters().particleCount;
        std::vector<std::vector<uint32_t>> colliders(count);
        for (uint32_t i = 0; i < count; ++i) colliders[i].resize(counts[2 * count + places[i].y], NO_INDEX);
        for (uint32_t k = 0; k < fixture.counters().candidateCount; ++k)
            colliders[candidates.at(k).x].at(candidates[k].z) = candidates[k].y;
        return colliders;
    }
    /// Compares with the distances to all colliders. @param reach per mover: how much further it looks [m].
    /// @returns the number of contacts to find, per collider.
    std::vector<uint32_t> expectAllInReach(const std::vector<float>& reach)
    {
        const auto colliders = download();
        std::vector<uint32_t> wanted(GetParam(), 0);
        for (uint32_t i = 0; i < colliders.size(); ++i) {
            EXPECT_TRUE(std::is_sorted(colliders[i].begin(), colliders[i].end())) << "particle " << i;
            const float limit = parameters().contactReach - DIAMETER / 2 + reach[places[i].x];
            for (uint32_t c = 0; c < GetParam(); ++c) {
                const float distance = colliderDistance(fixture.world, fixture.world.colliders[c], vec3(found[i]));
                if (std::abs(distance - limit) < ROUNDING) continue;
                const auto times = std::count(colliders[i].begin(), colliders[i].end(), c);
                EXPECT_EQ(times, distance < limit ? 1 : 0) << "particle " << i << ", collider " << c;
                wanted[c] += distance < limit;
            }
        }
        EXPECT_EQ(fixture.counters().problems, 0u);
        return wanted;
    }

    KernelFixture fixture;
    std::vector<gpu::vec4> centres, found;
    std::vector<gpu::uvec2> places;
};

TEST_P(ColliderFind, MoversKnowTheCollidersThatTheirParticlesMayTouch)
{
    fixture.forMovers("search/collider_near");
    const auto near = fixture.stages.search.moverColliders.download();
    const auto moments = fixture.stages.bodies.bodyMoments.download();
    for (uint32_t m = 0; m < near.size(); ++m) {
        const float radius = m < parameters().bodyCount ? moments[3 * m].w : 0.0f;
        const float limit = parameters().contactReach - DIAMETER / 2 + radius;
        uint32_t wanted = 0, either = 0;
        for (uint32_t c = 0; c < GetParam(); ++c) {
            const float distance = colliderDistance(fixture.world, fixture.world.colliders[c], vec3(centres[m]));
            if (distance < limit) wanted |= 1u << (c % 32);
            if (std::abs(distance - limit) < ROUNDING) either |= 1u << (c % 32);
        }
        ASSERT_EQ(near[m] | either, wanted | either) << "mover " << m;
    }
}

TEST_P(ColliderFind, ListsTheCollidersThatAParticleMayTouchOfThoseThatItsMoverMay)
{
    fixture.forMovers("search/collider_near");
    fixture.forParticles("search/collider_find");
    const auto contacts = expectAllInReach(std::vector<float>(centres.size(), 0.0f));
    EXPECT_LT(std::count(contacts.begin(), contacts.end(), 0u), 1 + GetParam() / 8) << "most have to be near something";
    EXPECT_GT(contacts.back(), 0u);
}

TEST_P(ColliderFind, ListsTheSameWhereNobodyHasLookedWhichAreNear)
{
    fixture.forParticles("search/collider_find");  // the paper's solver, with what the upload left
    expectAllInReach(std::vector<float>(centres.size(), 0.0f));
}

TEST_P(ColliderFind, FastMoversLookAsMuchFurtherForColliders)
{
    std::vector<float> reach(centres.size(), 0.0f);
    for (size_t m = 0; m < centres.size(); m += 2) reach[m] = 0.1f * parameters().farReach;
    for (size_t m = 0; m < centres.size(); ++m) centres[m].w = parameters().drift + reach[m];
    fill(fixture.stages.search.searchCentres, centres);
    fixture.forMovers("search/collider_near");
    fixture.forParticles("search/collider_find");
    expectAllInReach(reach);
}

std::string colliderCountName(const testing::TestParamInfo<uint32_t>& count)
{
    return "Of" + std::to_string(count.param);
}

// As many as a mover has bits, one less and more, and more than twice that.
INSTANTIATE_TEST_SUITE_P(Colliders, ColliderFind, testing::Values(4u, 31u, 32u, 33u, 70u), colliderCountName);

}  // namespace

}  // namespace knuckle::test
