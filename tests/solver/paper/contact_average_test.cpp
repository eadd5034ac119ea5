#include <algorithm>
#include <cmath>

#include "shared/paper_constants.h"
#include "tests/solver/contact/contact_fixture.h"

namespace knuckle::test {

namespace {

/// What a particle's contacts ask of it, in double precision; not sure if rounding decides a case.
struct Wanted {
    Vector3d move = Vector3d::Zero();
    double acting = 0.0;
    bool sure = true;
    void add(const Wanted& other, double factor)
    {
        move += factor * other.move;
        acting += other.acting;
        sure = sure && other.sure;
    }
};

constexpr uint32_t PARITY = 1;
constexpr double EDGE = 2e-6;  ///< Nearer to the limit of a case, rounding decides [m].

enum class Pass { Stabilize, Solve };

/// All particles in a heap 0.4 m wide, with 1501 contacts of each other and 700 with a plane and a sphere.
class ContactAverage : public testing::TestWithParam<Pass> {
protected:
    ContactAverage()
    {
        Random random(301);
        const size_t count = fixture.world.particles.size();
        gpu::StepParameters& p = fixture.stages.parameters;
        p.overRelaxation = 1.7f;
        p.maxCorrection = 0.01f;
        p.stabilization = 0.004f;
        p.deepOverlap = 0.04f;
        p.deepRecovery = 0.001f;
        fixture.setParameters();
        starts = randomVectors(count, 0.2f, 302);
        moves = randomVectors(count, 0.02f, 303);
        for (uint32_t i = 0; i < count; ++i) moves[i].w = isFixed(i) ? 0.0f : random.between(0.2f, 5.0f);
        fill(fixture.stages.particles.positions, starts);
        fill(fixture.stages.paper->predicted, moves);
        makeContacts(random, static_cast<float>(count));
        restOffsets = fixture.stages.particles.restOffsets.download();
        for (size_t b = 0; b < fixture.world.bodies.size(); ++b)
            acting.push_back({0, static_cast<uint32_t>(random.between(0.0f, 2.0f) * FRACTION_PARTS)});
        fixture.stages.paper->bodyActing.upload(std::span<const gpu::uvec2>(acting));
    }
    void makeContacts(Random& random, float count)
    {
        const auto any = [&] { return static_cast<uint32_t>(random.between(0, 0.999f) * count); };
        const auto frictions = [&](TestContact& c) {
            c.kineticFriction = std::floor(random.between(0, 4)) / 4;
            c.staticFriction = c.kineticFriction + std::floor(random.between(0, 3)) / 4;
        };
        std::vector<TestContact> pairs, planes;
        while (pairs.size() < 1501) {
            TestContact c{.first = any(), .second = any()};
            frictions(c);
            c.kin = pairs.size() % 2 == 0;
            if (fixture.moverOf[c.first] != fixture.moverOf[c.second]) pairs.push_back(c);
        }
        while (planes.size() < 700) {
            TestContact c{.first = any(), .second = planes.size() % 2 == 0 ? 0u : 1u};
            frictions(c);
            planes.push_back(c);
        }
        setPairs(pairs);
        fixture.setColliderContacts(planes);
    }
    void setPairs(const std::vector<TestContact>& pairs)
    {
        fixture.setPairs(pairs);
        std::vector<gpu::uvec2> listed;
        for (const TestContact& c : fixture.pairs) listed.push_back({c.first, c.second});
        fixture.stages.search.pairs.write(listed.data(), listed.size() * sizeof(gpu::uvec2),
                                          PARITY * fixture.stages.parameters.pairCapacity * sizeof(gpu::uvec2));
    }
    bool stabilize() const { return GetParam() == Pass::Stabilize; }
    /// The part of a particle's move that its body follows there: the particle's mass over the effective mass of the
    /// body.
    double share(uint32_t i) const { return double(restOffsets[i].w) * double(fixture.world.particles[i].mass); }
    /// As much as the body takes without answering by more than is asked, at most 1.7 times unless stabilizing.
    double relaxation(uint32_t i) const
    {
        const Particle& p = fixture.world.particles[i];
        if (p.body == NO_INDEX || inverseMass(i) == 0.0) return 1.0;
        const double pushed = double(acting[p.body].y) / double(FRACTION_PARTS);
        const double most = std::min(1.0 / share(i), double(MOST_FRACTION_SUM) / std::max(pushed, 1e-9));
        return stabilize() ? most : std::min(most, 1.7);
    }
    Vector3d start(uint32_t i) const { return vec3(starts[i]).cast<double>(); }
    Vector3d move(uint32_t i) const { return vec3(moves[i]).cast<double>(); }
    bool isFixed(uint32_t i) const { return knuckle::isFixed(fixture.world, fixture.world.particles[i]); }
    /// As predict gives it to contacts, scaled.
    double inverseMass(uint32_t i) const { return double(moves[i].w); }
    double sideShare(uint32_t own, uint32_t other) const
    {
        const double mine = inverseMass(own), sum = mine + inverseMass(other);
        return sum > 0.0 ? mine / sum : 0.0;
    }
    /// Eqs. 5-7 with friction (Macklin et al. 2014, eq. 24) and the bounds on old overlaps.
    Wanted push(const Vector3d& normal, double gap, double startGap, const Vector3d& slide, const TestContact& c) const
    {
        const gpu::StepParameters& p = fixture.stages.parameters;
        const double old = std::max(-startGap, 0.0);
        const bool deep = old > double(p.deepOverlap);
        const double kept = deep ? old : std::max(old - double(p.maxCorrection), 0.0);
        double error = std::min(gap + kept, 0.0);
        Wanted out;
        if (stabilize())
            error = deep ? -double(p.deepRecovery)
                         : -std::clamp(old - double(p.maxCorrection), 0.0, double(p.stabilization));
        for (const double limit : {old - double(p.deepOverlap), old - double(p.maxCorrection), gap + kept})
            out.sure = out.sure && std::abs(limit) > EDGE;
        out.acting = error < 0.0 ? 1.0 : 0.0;
        out.move = -error * normal;
        if (stabilize()) return out;
        const Vector3d tangent = slide - normal * normal.dot(slide);
        const double size = tangent.norm();
        const bool holds = size < -double(c.staticFriction) * error;
        out.sure = out.sure && std::abs(size + double(c.staticFriction) * error) > EDGE;
        out.move -= (holds ? 1.0 : std::min(-double(c.kineticFriction) * error / size, 1.0)) * tangent;
        return out;
    }
    void runPass()
    {
        fixture.forParticles("paper/contact_average", stabilize() ? Defines{{"STABILIZE", "1"}} : Defines{});
        gpu().checkErrors();
    }
    std::vector<Wanted> wanted() const
    {
        std::vector<Wanted> sums(starts.size());
        for (const TestContact& c : fixture.pairs) {
            const Vector3d apart = start(c.first) - start(c.second), slide = move(c.first) - move(c.second);
            const Vector3d now = apart + slide;
            const Wanted one = push(now.normalized(), now.norm() - double(DIAMETER), apart.norm() - double(DIAMETER),
                                    slide, c);
            sums[c.first].add(one, sideShare(c.first, c.second));
            sums[c.second].add(one, -sideShare(c.second, c.first));
        }
        for (const TestContact& c : fixture.colliderContacts) {
            const Collider& collider = fixture.world.colliders[c.second];
            const auto distance = [&](const Vector3d& place) {
                const Vector3d p = place - collider.position.cast<double>();
                const Vector3d up = collider.orientation.cast<double>() * Vector3d::UnitY();
                return collider.shape == ColliderShape::Plane ? p.dot(up) : p.norm() - double(collider.radius);
            };
            const Vector3d place = start(c.first) + move(c.first);
            const Vector3d normal = collider.shape == ColliderShape::Plane
                                        ? Vector3d(collider.orientation.cast<double>() * Vector3d::UnitY())
                                        : Vector3d((place - collider.position.cast<double>()).normalized());
            const Wanted one = push(normal, distance(place) - 0.5 * double(DIAMETER),
                                    distance(start(c.first)) - 0.5 * double(DIAMETER), move(c.first), c);
            sums[c.first].add(one, inverseMass(c.first) > 0.0 ? 1.0 : 0.0);
        }
        return sums;
    }

    ContactFixture fixture{byThePaper()};
    std::vector<gpu::vec4> starts, moves, restOffsets;
    std::vector<gpu::uvec2> acting;
};

TEST_P(ContactAverage, EachParticleMovesByTheMeanOfWhatItsContactsAsk)
{
    runPass();
    const auto found = fixture.stages.paper->moved.download();
    const auto sums = wanted();
    uint32_t pushed = 0, averaged = 0, unsure = 0;
    for (uint32_t i = 0; i < found.size(); ++i) {
        if (isFixed(i)) {
            EXPECT_EQ(vec3(found[i]), Vector3f::Zero()) << "particle " << i;
            continue;
        }
        if (!sums[i].sure) {
            ++unsure;
            continue;
        }
        const Vector3d mean = relaxation(i) / std::max(sums[i].acting, 1.0) * sums[i].move;
        const Vector3d whole = stabilize() ? mean : Vector3d(move(i) + mean);
        // Differences of places of 0.4 m, rounded some twenty times: 5e-7, and frictions held as halves are exact.
        ASSERT_LT((vec3(found[i]).cast<double>() - whole).norm(), 1e-6) << "particle " << i;
        pushed += mean.norm() > 1e-5;
        averaged += sums[i].acting > 1.0;
    }
    EXPECT_GT(pushed, 150u);
    EXPECT_GT(averaged, 20u);
    EXPECT_LT(unsure, 20u);
}

TEST_P(ContactAverage, ABodyKnowsHowMuchOfItIsPushed)
{
    fixture.setColliderContacts({});
    runPass();
    const auto found = fixture.stages.paper->bodyActing.download();
    const auto sums = wanted();
    std::vector<double> pushed(found.size()), unsure(found.size());
    for (uint32_t i = 0; i < sums.size(); ++i) {
        const Particle& p = fixture.world.particles[i];
        if (p.body == NO_INDEX || inverseMass(i) == 0.0) continue;
        if (sums[i].acting > 0.0) pushed[p.body] += share(i);
        // An integer less at most, for each.
        unsure[p.body] += sums[i].sure ? 2.0 / double(FRACTION_PARTS) : share(i);
    }
    double most = 0.0;
    for (size_t b = 0; b < found.size(); ++b) {
        EXPECT_NEAR(double(found[b].x) / double(FRACTION_PARTS), pushed[b], unsure[b] + 1e-5) << "body " << b;
        EXPECT_EQ(found[b].y, acting[b].y) << "body " << b;
        most = std::max(most, pushed[b]);
    }
    EXPECT_GT(most, 0.3);
}

INSTANTIATE_TEST_SUITE_P(Filters, ContactAverage, testing::Values(Pass::Stabilize, Pass::Solve),
                         [](const auto& test) { return test.param == Pass::Stabilize ? "Stabilize" : "Solve"; });

}  // namespace

}  // namespace knuckle::test
