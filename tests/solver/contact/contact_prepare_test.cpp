#include <algorithm>
#include <cmath>
#include <map>

#include "shared/contact_constants.h"
#include "tests/solver/contact/parting_fixture.h"

namespace knuckle::test {

namespace {

/// For a pair's mover; the upper bits are the exit direction (shaders/sim/common/contacts/one_sided.glsl).
constexpr uint32_t MOVERS = 0x7fffffu;

/// Data and memory of each pair.
class ContactPrepare : public testing::Test {
protected:
    void find()
    {
        fixture.findPairs(GridKind::Lattice);
        fixture.fillLists();
    }
    /// The current pairs, in order.
    std::vector<gpu::uvec2> pairs() const
    {
        const auto all = fixture.stages.search.pairs.download();
        const auto first = all.begin() + static_cast<std::ptrdiff_t>(start());
        return {first, first + fixture.counters().pairCount};
    }
    /// Where the impulses of the current pairs start.
    size_t start() const { return fixture.counters().listParity * fixture.stages.parameters.pairCapacity; }

    PartingFixture fixture;
};

gpu::vec4 impulseOfPair(gpu::uvec2 pair)
{
    return {float(pair.x), float(pair.y), 3.0f, 4.0f};
}

float meanOfPair(const gpu::vec4& impulse)
{
    return impulse.x + 0.5f * impulse.y;
}

TEST_F(ContactPrepare, PairsThatLastKeepTheirImpulsesAlsoWhenTheirParticlesChangePlaces)
{
    find();
    std::map<std::pair<uint32_t, uint32_t>, gpu::vec4> old;  // by first and second
    auto impulses = fixture.stages.contacts.pairImpulses.download();
    auto means = fixture.stages.contacts.pairMeans.download();
    const auto before = pairs();
    size_t first = start();
    for (size_t q = 0; q < before.size(); ++q) {
        old[{before[q].x, before[q].y}] = impulses[first + q] = impulseOfPair(before[q]);
        means[first + q] = meanOfPair(impulses[first + q]);
    }
    fill(fixture.stages.contacts.pairImpulses, impulses);
    fill(fixture.stages.contacts.pairMeans, means);
    // Particles that lay ahead lie behind in the mirror. Some pairs part, some come together.
    const auto shifts = randomVectors(fixture.count(), 0.06f, 12);
    auto mirrored = fixture.found;
    for (uint32_t i = 0; i < fixture.count(); ++i) mirrored[i] = packed(vec3(shifts[i]) - vec3(mirrored[i]));
    for (uint32_t i = 0; i < fixture.count(); i += 2) mirrored[i].y = -fixture.found[i].y;
    fixture.place(mirrored);
    fixture.turnHalves();
    find();
    impulses = fixture.stages.contacts.pairImpulses.download();
    means = fixture.stages.contacts.pairMeans.download();
    uint32_t kept = 0, swapped = 0, fresh = 0, touching = 0;
    const auto after = pairs();
    first = start();
    for (size_t q = 0; q < after.size(); ++q) {
        const auto [i, j] = after[q];
        const auto same = old.find({i, j}), turned = old.find({j, i});
        const gpu::vec4 actual = impulses[first + q];
        if (same == old.end() && turned == old.end()) {
            const Parting parting = fixture.partingOf(i, j);
            const bool overlap = parting.far < DIAMETER;
            if (!parting.sure || std::abs(parting.far - DIAMETER) < DISTANCE_ROUNDING) continue;
            ASSERT_EQ(vec3(actual), Vector3f::Zero()) << "particles " << i << " and " << j;
            ASSERT_EQ(means[first + q], 0.0f) << "particles " << i << " and " << j;
            ASSERT_EQ(actual.w, overlap ? float(ABOUT_TO_ACT) : 0.0f) << "particles " << i << " and " << j;
            ++(overlap ? touching : fresh);
            continue;
        }
        const bool swap = same == old.end();
        const gpu::vec4& last = (swap ? turned : same)->second;
        ASSERT_EQ(vec3(actual), (swap ? -1.0f : 1.0f) * vec3(last)) << "particles " << i << " and " << j;
        ASSERT_EQ(actual.w, last.w);
        ASSERT_EQ(means[first + q], meanOfPair(last)) << "particles " << i << " and " << j;
        ++(swap ? swapped : kept);
    }
    EXPECT_GT(kept, 100u);
    EXPECT_GT(swapped, 100u);
    EXPECT_GT(fresh, 100u);
    EXPECT_GT(touching, 100u);
}

TEST_F(ContactPrepare, PairsWithoutAPushAreAboutToActWhereTheyOverlap)
{
    find();
    // The same places again: all pairs stay, some without impulses, some already with the mark.
    auto impulses = fixture.stages.contacts.pairImpulses.download();
    const auto found = pairs();
    size_t first = start();
    for (size_t q = 0; q < found.size(); ++q) impulses[first + q] = {0, 0, 0, q % 2 == 0 ? float(ABOUT_TO_ACT) : 0};
    fill(fixture.stages.contacts.pairImpulses, impulses);
    fixture.place(fixture.found);
    fixture.turnHalves();
    find();
    impulses = fixture.stages.contacts.pairImpulses.download();
    const auto again = pairs();
    first = start();
    ASSERT_EQ(again.size(), found.size());
    for (size_t q = 0; q < again.size(); ++q) {
        const Parting parting = fixture.partingOf(again[q].x, again[q].y);
        const double gap = parting.far - DIAMETER;
        if (!parting.sure || std::abs(gap) < DISTANCE_ROUNDING) continue;
        ASSERT_EQ(impulses[first + q].w, gap < 0 || q % 2 == 0 ? float(ABOUT_TO_ACT) : 0.0f) << "pair " << q;
    }
}

TEST_F(ContactPrepare, APairKnowsItsMoversArmsAndFriction)
{
    find();
    const auto sides = fixture.stages.contacts.pairSides.download();
    const auto arms = fixture.stages.contacts.pairArms.download(),
               offsets = fixture.stages.particles.restOffsets.download();
    const auto found = pairs();
    const auto material = [&](uint32_t particle) -> const Material& {
        return fixture.world.materials[fixture.world.particles[particle].material];
    };
    for (size_t q = 0; q < found.size(); ++q) {
        const auto [i, j] = found[q];
        ASSERT_EQ(sides[q].x & MOVERS, fixture.moverOf(i)) << "pair " << q;
        ASSERT_EQ(sides[q].y & MOVERS, fixture.moverOf(j)) << "pair " << q;
        for (int side : {0, 1}) {
            const gpu::vec4& arm = arms[2 * q + static_cast<size_t>(side)];
            const gpu::vec4& wanted = offsets[side == 0 ? i : j];
            ASSERT_EQ(vec3(arm), vec3(wanted)) << "pair " << q;
        }
        // Half of the sum; for two loose particles, 2 / pi of that.
        const bool loose = std::min(sides[q].x & MOVERS, sides[q].y & MOVERS) >= fixture.world.bodies.size();
        const float share = loose ? 1.0f / static_cast<float>(M_PI) : 0.5f;
        const Eigen::Vector2f frictions = halves(sides[q].z);
        ASSERT_NEAR(frictions.x(), share * (material(i).staticFriction + material(j).staticFriction), HALF_ROUNDING);
        ASSERT_NEAR(frictions.y(), share * (material(i).kineticFriction + material(j).kineticFriction), HALF_ROUNDING);
    }
}

TEST_F(ContactPrepare, APairKnowsTheInverseMassesAlongItsNormalAsSharesOfTheWorst)
{
    find();
    const auto sides = fixture.stages.contacts.pairSides.download();
    const auto offsets = fixture.stages.particles.restOffsets.download();
    const auto arms = fixture.stages.contacts.pairArms.download();
    const auto found = pairs();
    uint32_t partial = 0, oneSided = 0, flat = 0;
    for (size_t q = 0; q < found.size(); q += 7) {
        const Parting parting = fixture.partingOf(found[q].x, found[q].y);
        if (!parting.sure) continue;
        ASSERT_EQ(sides[q].w >> 26, parting.hidden) << "pair " << q;
        oneSided += parting.oneSided;
        flat += !parting.oneSided && parting.hidden != 0 && parting.far > double(LEAST_FLAT * DIAMETER);
        for (int side : {0, 1}) {
            const uint32_t particle = side == 0 ? found[q].x : found[q].y;
            const gpu::vec4& arm = offsets[particle];
            const SideMass mass = fixture.massOf(particle, vec3(arm), parting.normal);
            const double wanted = mass.normal / mass.worst;
            const double worst = mass.worst;
            // Of the eigenvalue of a matrix: some 64 roundings.
            ASSERT_NEAR(arms[2 * q + static_cast<size_t>(side)].w, worst, 64 * 0x1p-24 * worst) << "pair " << q;
            const float share = static_cast<float>(sides[q].w >> (13 * side) & 0x1fffu) / 8191.0f;
            // 13 bits, and some 20 roundings of single precision.
            ASSERT_NEAR(share, wanted, 1.0 / 8191 + 20 * 0x1p-24) << "pair " << q << ", side " << side;
            partial += share < 0.9f;
        }
    }
    EXPECT_GT(partial, 100u);
    EXPECT_GT(oneSided, 100u);
    EXPECT_GT(flat, 100u);
}

TEST_F(ContactPrepare, APairKnowsItsWayOut)
{
    find();
    const auto sides = fixture.stages.contacts.pairSides.download();
    const auto found = pairs();
    uint32_t known = 0;
    for (size_t q = 0; q < found.size(); ++q) {
        const WayOut way = fixture.wayOut(found[q].x, found[q].y);
        const auto assembly = [&](uint32_t particle) { return fixture.world.particles[particle].assembly; };
        const uint32_t ofFirst = assembly(found[q].x);
        ASSERT_EQ((sides[q].x >> 23 & 1) == 1, ofFirst != NO_INDEX && ofFirst == assembly(found[q].y)) << "pair " << q;
        ASSERT_EQ(sides[q].x >> 31 == 1, !way.away.isZero()) << "pair " << q;
        if (way.away.isZero()) continue;
        ++known;
        ASSERT_EQ(sides[q].y >> 31 == 1, way.deep) << "pair " << q;
        const double u = 2.0 * (sides[q].x >> 24 & 127) / 127.0 - 1.0, v = 2.0 * (sides[q].y >> 24 & 127) / 127.0 - 1.0;
        Vector3d n(u, v, 1.0 - std::abs(u) - std::abs(v));
        const double fold = std::max(-n.z(), 0.0);
        n -= fold * Vector3d(u >= 0 ? 1 : -1, v >= 0 ? 1 : -1, 0);
        // Half a level, 1/127, on both axes moves n by up to root 6 of that, and its length is at least 1 / root 3.
        ASSERT_LT((n.normalized() - way.away).norm(), std::sqrt(18.0) / 127.0 + 1e-5) << "pair " << q;
    }
    EXPECT_GT(known, 100u);
}

}  // namespace

}  // namespace knuckle::test
