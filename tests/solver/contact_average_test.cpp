#include <algorithm>
#include <cmath>

#include "contact_bench.h"

namespace knuckle::test {

namespace {

/// What a particle's contacts ask of it, in double precision; not sure where rounding decides a case.
struct Wanted {
    Vector3d impulse = Vector3d::Zero();
    double acting = 0.0;
    bool sure = true;
};

constexpr uint32_t PARITY = 1;
constexpr double EDGE = 2e-6;   ///< Nearer to the limit of a case, rounding decides [m].

/// All particles in a heap 0.4 m wide, with 1501 contacts of each other and 700 with a plane and a sphere.
class ContactAverage : public testing::TestWithParam<bool> {
protected:
    ContactAverage()
    {
        Random random(301);
        const size_t count = bench.world.particles.size();
        gpu::StepParameters& p = bench.buffers.parameters;
        p.overRelaxation = 1.7f;
        p.maxCorrection = 0.01f;
        p.stabilization = 0.004f;
        p.deepOverlap = 0.04f;
        p.deepRecovery = 0.001f;
        p.massScaling = 1.5f;
        bench.setParameters();
        starts = randomVectors(count, 0.2f, 302);
        moves = randomVectors(count, 0.02f, 303);
        fill(bench.buffers.positions, starts);
        fill(bench.buffers.predicted, moves);
        makeContacts(random, static_cast<float>(count));
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
            if (bench.moverOf[c.first] != bench.moverOf[c.second]) pairs.push_back(c);
        }
        while (planes.size() < 700) {
            TestContact c{.first = any(), .second = planes.size() % 2 == 0 ? 0u : 1u};
            frictions(c);
            planes.push_back(c);
        }
        bench.setPairs(pairs);
        bench.setColliderContacts(planes);
        std::vector<gpu::uvec2> listed;
        for (const TestContact& c : bench.pairs) listed.push_back({c.first, c.second});
        bench.buffers.pairs.write(listed.data(), listed.size() * sizeof(gpu::uvec2),
                                  PARITY * bench.buffers.parameters.pairCapacity * sizeof(gpu::uvec2));
    }
    bool stabilize() const { return GetParam(); }
    Vector3d start(uint32_t i) const { return vec3(starts[i]).cast<double>(); }
    Vector3d move(uint32_t i) const { return vec3(moves[i]).cast<double>(); }
    /// m exp(-k height), Macklin et al. 2014, 5.2.
    double inverseMass(uint32_t i) const
    {
        const Particle& p = bench.world.particles[i];
        if (p.body != NO_INDEX && bench.world.bodies[p.body].motion == Motion::Fixed) return 0.0;
        return std::exp(1.5 * start(i).y()) / double(p.mass);
    }
    /// Eqs. 5-7 with friction (Macklin et al. 2014, eq. 24) and the bounds on old overlaps.
    Wanted push(const Vector3d& normal, double gap, double startGap, const Vector3d& slide, double inverse,
                const TestContact& c) const
    {
        const gpu::StepParameters& p = bench.buffers.parameters;
        Wanted out;
        const double old = std::max(-startGap, 0.0);
        const bool deep = old > p.deepOverlap;
        const double kept = deep ? old : std::max(old - p.maxCorrection, 0.0);
        double error = std::min(gap + kept, 0.0);
        if (stabilize()) error = deep ? -p.deepRecovery : -std::clamp(old - p.maxCorrection, 0.0, double(p.stabilization));
        for (const double limit : {old - p.deepOverlap, old - p.maxCorrection, stabilize() ? 1.0 : gap + kept})
            out.sure = out.sure && std::abs(limit) > EDGE;
        if (error >= 0.0 || inverse == 0.0) return out;
        out.impulse = -error * normal;
        out.acting = 1.0;
        if (!stabilize()) {
            const Vector3d tangent = slide - normal * normal.dot(slide);
            const double size = tangent.norm();
            const bool holds = size < -c.staticFriction * error;
            out.sure = out.sure && std::abs(size + c.staticFriction * error) > EDGE;
            out.impulse -= (holds ? 1.0 : std::min(-c.kineticFriction * error / size, 1.0)) * tangent;
        }
        out.impulse /= inverse;
        return out;
    }
    static void add(Wanted& sum, const Wanted& other, double side)
    {
        sum.impulse += side * other.impulse;
        sum.acting += other.acting;
        sum.sure = sum.sure && other.sure;
    }
    std::vector<Wanted> wanted() const
    {
        std::vector<Wanted> sums(starts.size());
        for (const TestContact& c : bench.pairs) {
            const Vector3d apart = start(c.first) - start(c.second), slide = move(c.first) - move(c.second);
            const Vector3d now = apart + slide;
            const Wanted one = push(now.normalized(), now.norm() - DIAMETER, apart.norm() - DIAMETER, slide,
                                    inverseMass(c.first) + inverseMass(c.second), c);
            add(sums[c.first], one, 1.0);
            add(sums[c.second], one, -1.0);
        }
        for (const TestContact& c : bench.colliderContacts) {
            const Collider& collider = bench.world.colliders[c.second];
            const auto distance = [&](const Vector3d& place) {
                const Vector3d p = place - collider.position.cast<double>();
                const Vector3d up = collider.orientation.cast<double>() * Vector3d::UnitY();
                return collider.shape == ColliderShape::Plane ? p.dot(up) : p.norm() - double(collider.radius);
            };
            const Vector3d place = start(c.first) + move(c.first);
            const Vector3d normal = collider.shape == ColliderShape::Plane
                                        ? Vector3d(collider.orientation.cast<double>() * Vector3d::UnitY())
                                        : Vector3d((place - collider.position.cast<double>()).normalized());
            add(sums[c.first], push(normal, distance(place) - 0.5 * DIAMETER, distance(start(c.first)) - 0.5 * DIAMETER,
                                    move(c.first), inverseMass(c.first), c), 1.0);
        }
        return sums;
    }

    ContactBench bench;
    std::vector<gpu::vec4> starts, moves;
};

TEST_P(ContactAverage, EachParticleMovesByTheMeanOfWhatItsContactsAsk)
{
    Defines defines = {{"MASS_SCALING", "1"}};
    if (stabilize()) defines.push_back({"STABILIZE", "1"});
    bench.forParticles("contact_average", defines);
    gpu().checkErrors();
    const auto found = bench.buffers.moved.download();
    const auto sums = wanted();
    uint32_t pushed = 0, averaged = 0, unsure = 0;
    for (uint32_t i = 0; i < found.size(); ++i) {
        if (!sums[i].sure) {
            ++unsure;
            continue;
        }
        const double relaxation = bench.world.particles[i].bodyCount > 0 ? 1.7 : 1.0;
        const Vector3d mean = relaxation / std::max(sums[i].acting, 1.0) * inverseMass(i) * sums[i].impulse;
        const Vector3d whole = stabilize() ? mean : Vector3d(move(i) + mean);
        // Differences of places of 0.4 m, rounded some twenty times: 5e-7, and frictions held as halves are exact.
        ASSERT_LT((vec3(found[i]).cast<double>() - whole).norm(), 1e-6) << "particle " << i;
        pushed += sums[i].acting > 0.0 && mean.norm() > 1e-5;
        averaged += sums[i].acting > 1.0;
    }
    EXPECT_GT(pushed, 200u);
    EXPECT_GT(averaged, 30u);
    EXPECT_LT(unsure, 20u);
}

INSTANTIATE_TEST_SUITE_P(Passes, ContactAverage, testing::Bool(),
                         [](const auto& test) { return test.param ? "Stabilize" : "Solve"; });

}  // namespace

}  // namespace knuckle::test
