#include <algorithm>
#include <cmath>
#include <map>

#include "shared/contact_constants.h"
#include "sim/world/collider_distance.h"
#include "tests/solver/contact/collider_world.h"
#include "tests/solver/search/search_test.h"

namespace knuckle::test {

namespace {

/// Contacts of particles at random places among the colliders, listed alternately in both halves of the lists.
class ColliderPrepare : public testing::Test {
protected:
    ColliderPrepare() : fixture(colliderWorld())
    {
        found = randomVectors(fixture.stages.parameters.particleCount, 0.5f, 61);
        places = fixture.stages.particles.particleRanks.download();
    }
    void find()
    {
        fixture.setFound(found);
        fixture.forParticles("search/collider_find");
        fixture.fillLists();
    }
    size_t start() const { return fixture.counters().listParity * fixture.stages.parameters.colliderPairCapacity; }
    /// The current contacts, in order: particle, collider.
    std::vector<gpu::uvec2> contacts() const
    {
        const auto all = fixture.stages.search.colliderPairs.download();
        const auto first = all.begin() + static_cast<std::ptrdiff_t>(start());
        return {first, first + fixture.counters().colliderPairCount};
    }
    /// The same, from what the particles found.
    std::vector<gpu::uvec2> wantedContacts() const
    {
        auto candidates = fixture.stages.search.candidates.download();
        candidates.resize(fixture.counters().candidateCount);
        std::erase_if(candidates, [](const gpu::uvec4& candidate) { return candidate.w != NO_INDEX; });
        std::ranges::sort(candidates, {},
                          [&](const gpu::uvec4& candidate) { return std::pair(places[candidate.x].y, candidate.z); });
        std::vector<gpu::uvec2> wanted;
        for (const gpu::uvec4& candidate : candidates) wanted.push_back({candidate.x, candidate.y});
        return wanted;
    }
    float gapOf(gpu::uvec2 contact) const
    {
        return colliderDistance(fixture.world, fixture.world.colliders[contact.y], vec3(found[contact.x])) -
               DIAMETER / 2;
    }
    /// Distances of turned colliders (collider_test.cpp).
    static constexpr float ROUNDING = 4e-6f;
    KernelFixture fixture;
    std::vector<gpu::vec4> found;
    std::vector<gpu::uvec2> places;
};

void expectSame(const std::vector<gpu::uvec2>& actual, const std::vector<gpu::uvec2>& wanted)
{
    ASSERT_EQ(actual.size(), wanted.size());
    for (size_t q = 0; q < actual.size(); ++q) {
        ASSERT_EQ(actual[q].x, wanted[q].x) << "contact " << q;
        ASSERT_EQ(actual[q].y, wanted[q].y) << "contact " << q;
    }
}

TEST_F(ColliderPrepare, TheContactsOfEachRankStandTogetherInBothHalves)
{
    for (int half : {0, 1}) {
        SCOPED_TRACE(half);
        find();
        const auto wanted = wantedContacts();
        ASSERT_GT(wanted.size(), 200u);
        expectSame(contacts(), wanted);
        const auto dispatches = fixture.stages.dispatches.download();
        for (uint32_t k : {DISPATCH_COLLIDER_PAIRS, DISPATCH_NEW_COLLIDER_PAIRS})
            EXPECT_EQ(dispatches[k].x, groupsFor(wanted.size()));
        found = randomVectors(found.size(), 0.5f, 62);
        fixture.turnHalves();
    }
}

TEST_F(ColliderPrepare, ContactsThatLastKeepTheirImpulsesAndFreshOnesHaveNone)
{
    find();
    auto impulses = fixture.stages.contacts.colliderImpulses.download();
    auto means = fixture.stages.contacts.colliderMeans.download();
    std::map<std::pair<uint32_t, uint32_t>, gpu::vec4> old;
    const auto before = contacts();
    size_t first = start();
    for (size_t q = 0; q < before.size(); ++q) {
        old[{before[q].x, before[q].y}] = impulses[first + q] = {float(before[q].x), float(before[q].y), 3, 4};
        means[first + q] = 5.0f + float(before[q].x);
    }
    fill(fixture.stages.contacts.colliderImpulses, impulses);
    fill(fixture.stages.contacts.colliderMeans, means);
    const auto shifts = randomVectors(found.size(), 0.12f, 63);
    for (size_t i = 0; i < found.size(); ++i) found[i] = packed(vec3(found[i]) + vec3(shifts[i]));
    fixture.turnHalves();
    find();
    impulses = fixture.stages.contacts.colliderImpulses.download();
    means = fixture.stages.contacts.colliderMeans.download();
    uint32_t kept = 0, fresh = 0, touching = 0;
    const auto after = contacts();
    first = start();
    for (size_t q = 0; q < after.size(); ++q) {
        const gpu::vec4& actual = impulses[first + q];
        const auto last = old.find({after[q].x, after[q].y});
        const float gap = gapOf(after[q]);
        if (last == old.end() && std::abs(gap) < ROUNDING) continue;
        const gpu::vec4 wanted = last != old.end() ? last->second
                                                   : gpu::vec4{0, 0, 0, gap < 0 ? float(ABOUT_TO_ACT) : 0.0f};
        ASSERT_EQ(vec3(actual), vec3(wanted)) << "particle " << after[q].x << ", collider " << after[q].y;
        ASSERT_EQ(actual.w, wanted.w) << "particle " << after[q].x << ", collider " << after[q].y;
        ASSERT_EQ(means[first + q], last != old.end() ? 5.0f + wanted.x : 0.0f) << "particle " << after[q].x;
        ++(last != old.end() ? kept : gap < 0 ? touching : fresh);
    }
    EXPECT_GT(kept, 100u);
    EXPECT_GT(fresh, 20u);
    EXPECT_GT(touching, 20u);
}

TEST_F(ColliderPrepare, AContactKnowsItsMoverColliderArmAndFriction)
{
    find();
    const auto sides = fixture.stages.contacts.colliderSides.download();
    const auto arms = fixture.stages.contacts.colliderArms.download(),
               offsets = fixture.stages.particles.restOffsets.download();
    const auto ends = fixture.stages.particles.latticeEnds.download();
    const auto all = contacts();
    uint32_t corners = 0;
    for (size_t q = 0; q < all.size(); ++q) {
        const auto [i, c] = all[q];
        const Material& material = fixture.world.materials[fixture.world.particles[i].material];
        const Collider& collider = fixture.world.colliders[c];
        ASSERT_EQ(sides[q].x, places[i].x) << "contact " << q;
        ASSERT_EQ(sides[q].y, c) << "contact " << q;
        // Its surface is half a diameter from a ball's centre, or it is the corner or face of its box.
        const Vector3f fromCentre = vec3(arms[q]) - vec3(offsets[i]);
        const bool mayBeCorner = ends[i] % LATTICE_ENDS != 0;
        if (!mayBeCorner) {
            ASSERT_NEAR(fromCentre.norm(), 0.5f * DIAMETER, 1e-5f) << "contact " << q;
        }
        corners += fromCentre.norm() > 0.51f * DIAMETER;
        const Vector3f place = vec3(found[i]) + fromCentre;  // bodies have not turned
        const float touching = colliderDistance(fixture.world, collider, place);
        const float asBall = colliderDistance(fixture.world, collider, vec3(found[i])) - DIAMETER / 2;
        // Inside, the way out may change within half a diameter.
        if (asBall < 0.0f) continue;
        ASSERT_NEAR(touching, asBall, mayBeCorner ? 0.4f * DIAMETER : ROUNDING) << "contact " << q;
        const Eigen::Vector2f friction = halves(sides[q].z);
        ASSERT_NEAR(friction.x(), 0.5f * (material.staticFriction + collider.staticFriction), HALF_ROUNDING);
        ASSERT_NEAR(friction.y(), 0.5f * (material.kineticFriction + collider.kineticFriction), HALF_ROUNDING);
    }
    EXPECT_GT(corners, 10u);
}

TEST_F(ColliderPrepare, MoreContactsThanThereIsRoomForAreReportedAndLeftOut)
{
    constexpr uint32_t ROOM = 101;
    Stages& b = fixture.stages;
    b.parameters.colliderPairCapacity = ROOM;
    fixture.setParameters();
    fixture.turnHalves();
    fill(b.search.colliderPairs, std::vector<gpu::uvec2>(b.search.colliderPairs.size(), gpu::uvec2{77, 78}));
    fill(b.contacts.colliderSides, std::vector<gpu::uvec4>(b.contacts.colliderSides.size(), gpu::uvec4{9, 9, 9, 9}));
    for (auto* buffer : {&b.contacts.colliderArms, &b.contacts.colliderImpulses})
        fill(*buffer, std::vector<gpu::vec4>(buffer->size(), gpu::vec4{7, 7, 7, 7}));
    find();
    auto wanted = wantedContacts();
    ASSERT_GT(wanted.size(), ROOM);
    EXPECT_EQ(fixture.counters().problems, PROBLEM_PAIRS);
    EXPECT_EQ(fixture.counters().wantedColliderPairs, wanted.size());
    EXPECT_EQ(fixture.counters().colliderPairCount, ROOM);
    wanted.resize(ROOM);
    expectSame(contacts(), wanted);
    const auto pairs = b.search.colliderPairs.download();
    const auto sides = b.contacts.colliderSides.download();
    const auto arms = b.contacts.colliderArms.download(), impulses = b.contacts.colliderImpulses.download();
    for (size_t q = 0; q < pairs.size(); ++q) {
        const bool filled = q >= ROOM && q < 2 * ROOM;
        ASSERT_EQ(pairs[q].x == 77u && pairs[q].y == 78u, !filled) << "contact " << q;
        ASSERT_EQ(impulses[q].x == 7.0f, !filled) << "impulse " << q;
        if (q < ROOM || q >= sides.size()) continue;
        ASSERT_EQ(sides[q].x, 9u) << "contact " << q;
        ASSERT_EQ(arms[q].x, 7.0f) << "arm " << q;
    }
}

}  // namespace

}  // namespace knuckle::test
