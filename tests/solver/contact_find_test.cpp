#include <algorithm>
#include <set>

#include "solver_test.h"

namespace knuckle::test {

namespace {

/// Particles at random places, whatever body they are of, those of bodies in a small space: pairs of every kind come
/// near each other.
class ContactFind : public testing::TestWithParam<GridKind> {
protected:
    ContactFind() : bench(mixedWorld())
    {
        bench.buffers.resizeContacts(gpu(), 96);
        bodies.resize(count());
        for (const Link& link : bench.world.links) bodies[link.particle].insert(link.body);
        auto positions = randomVectors(count(), 0.5f, 11);
        for (uint32_t i = 0; i < count(); ++i)
            if (!bodies[i].empty()) positions[i] = packed(0.4f * vec3(positions[i]));
        fill(bench.buffers.positions, positions);
    }
    uint32_t count() const { return bench.buffers.parameters.particleCount; }
    void find()
    {
        bench.fillGrid(gridDefines(GetParam()));
        bench.forParticles("contact_find", gridDefines(GetParam()));
    }
    /// The list of a particle, in slot order.
    std::vector<uint32_t> listOf(uint32_t i, uint32_t parity = 0)
    {
        const uint32_t slots = bench.buffers.parameters.contactSlots;
        std::vector<uint32_t> list;
        for (uint32_t s = 0; s < counts[parity * count() + i].x; ++s)
            list.push_back(candidates[(parity * (slots + COLLIDER_SLOTS) + s) * count() + i]);
        return list;
    }
    void download()
    {
        counts = bench.buffers.candidateCounts.download();
        candidates = bench.buffers.candidates.download();
    }
    static float restDistance(const Particle& a, const Particle& b)
    {
        return (a.restPosition - b.restPosition).norm();
    }
    static float leastRestDistance(const Particle& a, const Particle& b)
    {
        return (0.99f + std::max(a.selfMargin, b.selfMargin)) * DIAMETER;
    }
    /// Written anew from the rules: never of one body; of one assembly, neither a universal joint's cross nor nearer
    /// than a diameter and a margin at rest.
    bool mayTouch(uint32_t i, uint32_t j) const
    {
        const Particle& a = bench.world.particles[i];
        const Particle& b = bench.world.particles[j];
        for (uint32_t body : bodies[i])
            if (bodies[j].contains(body)) return false;
        if (a.assembly == NO_INDEX || a.assembly != b.assembly) return true;
        return a.touchesAssembly && b.touchesAssembly && restDistance(a, b) > leastRestDistance(a, b);
    }
    /// Partners of a particle by comparing it with all.
    std::set<uint32_t> partners(uint32_t i, const std::vector<gpu::vec4>& positions) const
    {
        std::set<uint32_t> found;
        for (uint32_t j = 0; j < count(); ++j)
            if (j != i && (vec3(positions[i]) - vec3(positions[j])).norm() < bench.buffers.parameters.contactRadius &&
                mayTouch(i, j))
                found.insert(j);
        return found;
    }

    Bench bench;
    std::vector<std::set<uint32_t>> bodies;   ///< Per particle.
    std::vector<gpu::uvec2> counts;
    std::vector<uint32_t> candidates;
};

TEST_P(ContactFind, FindsWhatASearchOfAllPairsFinds)
{
    find();
    download();
    const auto positions = bench.buffers.positions.download();
    size_t pairs = 0, excluded = 0;
    for (uint32_t i = 0; i < count(); ++i) {
        const auto list = listOf(i);
        const std::set<uint32_t> found(list.begin(), list.end());
        EXPECT_EQ(found.size(), list.size()) << "particle " << i << " has a partner twice";
        EXPECT_EQ(found, partners(i, positions)) << "particle " << i;
        pairs += list.size();
        for (uint32_t j = 0; j < count(); ++j)
            excluded += j != i && (vec3(positions[i]) - vec3(positions[j])).norm() < DIAMETER && !mayTouch(i, j);
    }
    EXPECT_GT(pairs, 2000u) << "the world is too thin to test anything";
    EXPECT_GT(excluded, 20u);
    EXPECT_EQ(bench.counters().problems, 0u);
}

TEST_P(ContactFind, TheRulesOfWhatTouchesAllMatterHere)
{
    // Near each other and not of one first body, but excluded, by each rule alone: else the test above would prove
    // less than it says.
    uint32_t crosses = 0, overlaps = 0, margins = 0, shared = 0;
    const auto& particles = bench.world.particles;
    const auto positions = bench.buffers.positions.download();
    for (uint32_t i = 0; i < count(); ++i)
        for (uint32_t j = 0; j < i; ++j) {
            const Particle& a = particles[i];
            const Particle& b = particles[j];
            if (a.assembly != b.assembly || a.assembly == NO_INDEX || a.body == b.body) continue;
            if ((vec3(positions[i]) - vec3(positions[j])).norm() > DIAMETER) continue;
            const bool overlap = restDistance(a, b) <= leastRestDistance(a, b);
            const bool cross = !a.touchesAssembly || !b.touchesAssembly;
            crosses += cross && !overlap;
            overlaps += overlap && !cross && restDistance(a, b) <= 0.99f * DIAMETER;
            margins += overlap && !cross && restDistance(a, b) > DIAMETER;
            shared += !overlap && !cross && !mayTouch(i, j);
        }
    EXPECT_GT(crosses, 0u);
    EXPECT_GT(overlaps, 0u);
    EXPECT_GT(margins, 0u);
    EXPECT_GT(shared, 0u) << "a shared particle and one of its second body";
}

TEST_P(ContactFind, ContactsThatLastKeepTheirImpulses)
{
    find();
    download();
    // Each contact gets an impulse that tells it.
    const uint32_t slots = bench.buffers.parameters.contactSlots;
    auto impulses = bench.buffers.impulses.download();
    const auto impulseOf = [](uint32_t i, uint32_t j) { return gpu::vec4{float(i), float(j), 3.0f, 4.0f}; };
    for (uint32_t i = 0; i < count(); ++i) {
        const auto list = listOf(i);
        for (uint32_t s = 0; s < list.size(); ++s) impulses[s * count() + i] = impulseOf(i, list[s]);
    }
    fill(bench.buffers.impulses, impulses);
    const auto old = candidates;
    const auto oldCounts = counts;
    fill(bench.buffers.predicted, randomVectors(count(), 0.03f, 12));   // some leave, some come
    gpu::Counters now = bench.counters();
    now.listParity = 1;
    bench.setCounters(now);
    find();
    download();
    impulses = bench.buffers.impulses.download();
    uint32_t kept = 0, fresh = 0;
    for (uint32_t i = 0; i < count(); ++i) {
        const auto before = listOf(i, 0), after = listOf(i, 1);
        for (uint32_t s = 0; s < after.size(); ++s) {
            const bool known = std::find(before.begin(), before.end(), after[s]) != before.end();
            const gpu::vec4 wanted = known ? impulseOf(i, after[s]) : gpu::vec4{};
            const gpu::vec4& actual = impulses[(slots + COLLIDER_SLOTS + s) * count() + i];
            ASSERT_EQ(vec3(actual), vec3(wanted)) << "particle " << i << " and " << after[s];
            ASSERT_EQ(actual.w, wanted.w);
            ++(known ? kept : fresh);
        }
    }
    EXPECT_GT(kept, 500u);
    EXPECT_GT(fresh, 100u);
}

TEST_P(ContactFind, AListThatIsTooShortIsReportedWithTheSizeItWants)
{
    bench.buffers.resizeContacts(gpu(), 3);
    find();
    download();
    const auto positions = bench.buffers.positions.download();
    uint32_t most = 0;
    for (uint32_t i = 0; i < count(); ++i) {
        const auto all = partners(i, positions);
        most = std::max(most, static_cast<uint32_t>(all.size()));
        EXPECT_EQ(listOf(i).size(), std::min<size_t>(all.size(), 3)) << "particle " << i;
        for (uint32_t j : listOf(i)) EXPECT_TRUE(all.contains(j));
    }
    EXPECT_EQ(bench.counters().problems, PROBLEM_CONTACTS);
    EXPECT_EQ(bench.counters().wantedContacts, most);
}

INSTANTIATE_TEST_SUITE_P(Kinds, ContactFind, testing::Values(GridKind::Lattice, GridKind::Hash), gridName);

}  // namespace

}  // namespace knuckle::test
