#include <algorithm>
#include <cmath>
#include <map>

#include "search_test.h"
#include "sim/solver/body_mass.h"

namespace knuckle::test {

namespace {

/// Of a pair's mover; the upper bits tell the way out (shaders/shared/one_sided.glsl).
constexpr uint32_t MOVERS = 0x7fffffu;

/// The way out for the first of a pair, as the kernel decides it, and whether it is deep.
struct WayOut {
    Vector3d away{0, 0, 0};
    bool deep = false;
};

/// How a pair parts: by the way out, mirrored, by a face, or simply from each other.
struct Parting {
    Vector3d normal;
    double far = 0.0;
    uint32_t hidden = 0;
    bool oneSided = false;
    bool sure = true;    ///< Not so near a limit that rounding decides.
};

/// What each pair is made of, and what it remembers.
class PairWrite : public testing::Test {
protected:
    PairWrite() : bodiesOfAssembly(bench.world.assemblyCount)
    {
        for (const Body& body : bench.world.bodies) ++bodiesOfAssembly[body.assembly];
        setTurnsAndInertias();
    }
    void find()
    {
        bench.findPairs(GridKind::Lattice);
        bench.fillLists();
    }
    /// The current pairs, in order.
    std::vector<gpu::uvec2> pairs() const
    {
        const auto all = bench.buffers.pairs.download();
        const auto first = all.begin() + static_cast<std::ptrdiff_t>(start());
        return {first, first + bench.counters().pairCount};
    }
    /// Where the impulses of the current pairs start.
    size_t start() const { return bench.counters().listParity * bench.buffers.parameters.pairCapacity; }
    /// Turns of the movers, and inverse inertias of the bodies that no box has: nothing in them is zero [1/(kg m2)].
    void setTurnsAndInertias()
    {
        Random random(41);
        std::vector<gpu::vec4> packedTurns;
        for (uint32_t m = 0; m < bench.buffers.parameters.moverCount; ++m) {
            turns.push_back(random.rotation());
            packedTurns.push_back(packed(turns.back()));
        }
        fill(bench.buffers.foundRotations, packedTurns);
        std::vector<gpu::vec4> packedInertias;
        for (const Body& body : bench.world.bodies) {
            const BodyMass mass = bodyMass(bench.world, body);
            const double radius = std::max(mass.radius, 0.05);   // of a body of one particle: none
            const auto size = static_cast<float>(1.0 / (mass.mass * radius * radius));
            const Vector3f diagonal = size * Vector3f(1.5f, 1.5f, 1.5f) + random.inCube(0.5f * size);
            const Vector3f other = random.inCube(0.5f * size);   // xy, xz, yz
            packedInertias.push_back(packed(diagonal, static_cast<float>(1.0 / mass.mass)));
            packedInertias.push_back(packed(other));
            Matrix3d inertia = diagonal.cast<double>().asDiagonal();
            inertia(0, 1) = inertia(1, 0) = static_cast<double>(other.x());
            inertia(0, 2) = inertia(2, 0) = static_cast<double>(other.y());
            inertia(1, 2) = inertia(2, 1) = static_cast<double>(other.z());
            inertias.push_back(inertia);
        }
        fill(bench.buffers.bodyInertias, packedInertias);
    }
    /// 1/M plus what turning adds: (r x n) I^-1 (r x n), for a unit impulse along n on a particle at r.
    double inverseMass(uint32_t particle, const Vector3f& r, const Vector3d& normal) const
    {
        const Particle& p = bench.world.particles[particle];
        if (p.body == NO_INDEX) return 1.0 / static_cast<double>(p.mass);
        const Vector3d t = r.cast<double>().cross(turns[p.body].conjugate().cast<double>() * normal);
        return 1.0 / bodyMass(bench.world, bench.world.bodies[p.body]).mass + t.dot(inertias[p.body] * t);
    }

    /// By the particle that is nearer to its surface, or between both; none within an assembly.
    WayOut wayOut(uint32_t i, uint32_t j) const
    {
        const uint32_t assembly = bench.world.particles[i].assembly;
        if (assembly != NO_INDEX && assembly == bench.world.particles[j].assembly) return {};
        const auto known = [&](uint32_t particle) {
            const Particle& p = bench.world.particles[particle];
            return p.bodyCount == 1 && !p.surface.outward.isZero();
        };
        const auto outward = [&](uint32_t particle) -> Vector3d {
            if (!known(particle)) return Vector3d::Zero();
            const Particle& p = bench.world.particles[particle];
            return turns[p.body].cast<double>() * p.surface.outward.cast<double>();
        };
        const double first = std::abs(bench.world.particles[i].surface.distance);
        const double second = std::abs(bench.world.particles[j].surface.distance);
        const bool alike = known(i) && known(j) && std::abs(second - first) < 0.25 * DIAMETER;
        const bool byFirst = known(i) && (!known(j) || second > first);
        const Vector3d away = alike ? Vector3d(outward(j) - outward(i)) : Vector3d(byFirst ? -outward(i) : outward(j));
        if (away.norm() <= 0.3) return {};
        return {away.normalized(), (byFirst ? first : second) >= DIAMETER};
    }
    Vector3d apart(uint32_t i, uint32_t j) const
    {
        return (vec3(bench.found[i]) - vec3(bench.found[j])).cast<double>();
    }
    /// Where a box without joints goes on from the particle towards another beside it, the other's place does not count.
    /// `sure` becomes false where rounding decides.
    Vector3d shown(uint32_t particle, const Vector3d& towards, uint32_t& hidden, bool& sure) const
    {
        const Particle& p = bench.world.particles[particle];
        Vector3d out = towards;
        hidden = 0;
        if (p.bodyCount != 1 || bodiesOfAssembly.at(p.assembly) > 1) return out;
        for (int axis = 0; axis < 3; ++axis) {
            const Vector3d along = turns[p.body].cast<double>() * Vector3d::Unit(axis);
            const double t = along.dot(towards);
            sure = sure && std::min(std::abs(t), std::abs(std::abs(t) - BESIDE * DIAMETER)) > DISTANCE_ROUNDING;
            if (std::abs(t) >= BESIDE * DIAMETER || (p.surface.ends >> (2 * axis + (t > 0)) & 1)) continue;
            out -= along * t;
            hidden |= 1u << axis;
        }
        return out;
    }
    Parting partingOf(uint32_t i, uint32_t j) const
    {
        const WayOut way = wayOut(i, j);
        const Vector3d r = apart(i, j);
        const double far = r.norm(), facing = r.dot(way.away);
        const bool known = !way.away.isZero();
        Parting out;
        out.sure = std::abs(facing / far) > 1e-4 && std::abs(facing / far - 0.5) > 1e-4;
        uint32_t first = 0, second = 0;
        const Vector3d byFirst = shown(i, -r, first, out.sure), bySecond = shown(j, r, second, out.sure);
        out.hidden = first | second << 3;
        const bool between = known && far < (facing < 0.5 * far ? SUNK : 0.5) * DIAMETER;
        const bool isDeep = known && way.deep && far < DIAMETER;
        out.far = far;
        out.normal = r / far;
        out.oneSided = between || isDeep || facing < 0;
        if (between || isDeep) out.normal = way.away;
        else if (facing < 0) out.normal = (r - 2.0 * facing * way.away) / far;
        else if (out.hidden != 0) {
            const bool ofFirst = byFirst.norm() < bySecond.norm();
            const Vector3d flat = ofFirst ? Vector3d(-byFirst) : bySecond;
            out.sure = out.sure && std::abs(flat.norm() - double(LEAST_FLAT * DIAMETER)) > DISTANCE_ROUNDING;
            if (flat.norm() <= double(LEAST_FLAT * DIAMETER)) return out;
            out.far = flat.norm();
            out.normal = flat / out.far;
        }
        return out;
    }

    SearchBench bench;
    std::vector<Quaternionf> turns;      ///< Per mover.
    std::vector<Matrix3d> inertias;      ///< Per body, inverse.
    std::vector<uint32_t> bodiesOfAssembly;
};

gpu::vec4 impulseOfPair(gpu::uvec2 pair)
{
    return {float(pair.x), float(pair.y), 3.0f, 4.0f};
}

float meanOfPair(const gpu::vec4& impulse)
{
    return impulse.x + 0.5f * impulse.y;
}

TEST_F(PairWrite, PairsThatLastKeepTheirImpulsesAlsoWhenTheirParticlesChangePlaces)
{
    find();
    std::map<std::pair<uint32_t, uint32_t>, gpu::vec4> old;   // by first and second
    auto impulses = bench.buffers.pairImpulses.download();
    auto means = bench.buffers.pairMeans.download();
    const auto before = pairs();
    size_t first = start();
    for (size_t q = 0; q < before.size(); ++q) {
        old[{before[q].x, before[q].y}] = impulses[first + q] = impulseOfPair(before[q]);
        means[first + q] = meanOfPair(impulses[first + q]);
    }
    fill(bench.buffers.pairImpulses, impulses);
    fill(bench.buffers.pairMeans, means);
    // What lay ahead lies behind in the mirror. Some pairs part, some come together.
    const auto shifts = randomVectors(bench.count(), 0.06f, 12);
    auto mirrored = bench.found;
    for (uint32_t i = 0; i < bench.count(); ++i) mirrored[i] = packed(vec3(shifts[i]) - vec3(mirrored[i]));
    for (uint32_t i = 0; i < bench.count(); i += 2) mirrored[i].y = -bench.found[i].y;
    bench.place(mirrored);
    bench.turnHalves();
    find();
    impulses = bench.buffers.pairImpulses.download();
    means = bench.buffers.pairMeans.download();
    uint32_t kept = 0, swapped = 0, fresh = 0, touching = 0;
    const auto after = pairs();
    first = start();
    for (size_t q = 0; q < after.size(); ++q) {
        const auto [i, j] = after[q];
        const auto same = old.find({i, j}), turned = old.find({j, i});
        const gpu::vec4 actual = impulses[first + q];
        if (same == old.end() && turned == old.end()) {
            const Parting parting = partingOf(i, j);
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

TEST_F(PairWrite, PairsWithoutAPushAreAboutToActWhereTheyOverlap)
{
    find();
    // The same places again: all pairs last, some with nothing, some with the mark already.
    auto impulses = bench.buffers.pairImpulses.download();
    const auto found = pairs();
    size_t first = start();
    for (size_t q = 0; q < found.size(); ++q) impulses[first + q] = {0, 0, 0, q % 2 == 0 ? float(ABOUT_TO_ACT) : 0};
    fill(bench.buffers.pairImpulses, impulses);
    bench.place(bench.found);
    bench.turnHalves();
    find();
    impulses = bench.buffers.pairImpulses.download();
    const auto again = pairs();
    first = start();
    ASSERT_EQ(again.size(), found.size());
    for (size_t q = 0; q < again.size(); ++q) {
        const Parting parting = partingOf(again[q].x, again[q].y);
        const double gap = parting.far - DIAMETER;
        if (!parting.sure || std::abs(gap) < DISTANCE_ROUNDING) continue;
        ASSERT_EQ(impulses[first + q].w, gap < 0 || q % 2 == 0 ? float(ABOUT_TO_ACT) : 0.0f) << "pair " << q;
    }
}

TEST_F(PairWrite, APairKnowsItsMoversArmsAndFriction)
{
    find();
    const auto sides = bench.buffers.pairSides.download();
    const auto arms = bench.buffers.pairArms.download(), offsets = bench.buffers.restOffsets.download();
    const auto found = pairs();
    const auto material = [&](uint32_t particle) -> const Material& {
        return bench.world.materials[bench.world.particles[particle].material];
    };
    for (size_t q = 0; q < found.size(); ++q) {
        const auto [i, j] = found[q];
        ASSERT_EQ(sides[q].x & MOVERS, bench.moverOf(i)) << "pair " << q;
        ASSERT_EQ(sides[q].y & MOVERS, bench.moverOf(j)) << "pair " << q;
        for (int side : {0, 1}) {
            const gpu::vec4& arm = arms[2 * q + static_cast<size_t>(side)];
            const gpu::vec4& wanted = offsets[side == 0 ? i : j];
            ASSERT_EQ(vec3(arm), vec3(wanted)) << "pair " << q;
            ASSERT_EQ(arm.w, wanted.w) << "pair " << q;
        }
        // Half of the sum; of two loose particles, 2 / pi of that.
        const bool loose = std::min(sides[q].x & MOVERS, sides[q].y & MOVERS) >= bench.world.bodies.size();
        const float share = loose ? 1.0f / static_cast<float>(M_PI) : 0.5f;
        const Eigen::Vector2f frictions = halves(sides[q].z);
        ASSERT_NEAR(frictions.x(), share * (material(i).staticFriction + material(j).staticFriction), HALF_ROUNDING);
        ASSERT_NEAR(frictions.y(), share * (material(i).kineticFriction + material(j).kineticFriction), HALF_ROUNDING);
    }
}

TEST_F(PairWrite, APairKnowsTheInverseMassesAlongItsNormalAsSharesOfTheWorst)
{
    find();
    const auto sides = bench.buffers.pairSides.download();
    const auto offsets = bench.buffers.restOffsets.download();
    const auto found = pairs();
    uint32_t partial = 0, oneSided = 0, flat = 0;
    for (size_t q = 0; q < found.size(); q += 7) {
        const Parting parting = partingOf(found[q].x, found[q].y);
        if (!parting.sure) continue;
        ASSERT_EQ(sides[q].w >> 26, parting.hidden) << "pair " << q;
        oneSided += parting.oneSided;
        flat += !parting.oneSided && parting.hidden != 0 && parting.far > double(LEAST_FLAT * DIAMETER);
        for (int side : {0, 1}) {
            const uint32_t particle = side == 0 ? found[q].x : found[q].y;
            const gpu::vec4& arm = offsets[particle];
            // Fixed movers have no worst.
            const double mass = inverseMass(particle, vec3(arm), parting.normal);
            const double wanted = arm.w == 0.0f ? 1.0 : std::min(mass / static_cast<double>(arm.w), 1.0);
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

TEST_F(PairWrite, APairKnowsItsWayOut)
{
    find();
    const auto sides = bench.buffers.pairSides.download();
    const auto found = pairs();
    uint32_t known = 0;
    for (size_t q = 0; q < found.size(); ++q) {
        const WayOut way = wayOut(found[q].x, found[q].y);
        const auto assembly = [&](uint32_t particle) { return bench.world.particles[particle].assembly; };
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
