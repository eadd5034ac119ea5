#include <cmath>

#include "sim/solver/layout/body_mass.h"
#include "tests/solver/restitution/restitution_fixture.h"

namespace knuckle::test {

namespace {

/// Energy that a mover affords, in double precision.
struct Purse {
    Vector3d ledger = Vector3d::Zero();
    double budget = 0.0, push = 0.0;  ///< [J]
    double error = 0.0;               ///< Of the budget, by rounding [J].
};

class MoverShare : public Restitution {
protected:
    MoverShare() : purses(fixture.moverCount())
    {
        Random random(221);
        const auto some = [&](Buffer<gpu::vec4>& buffer) {
            std::vector<gpu::vec4> ledgers(buffer.size());
            for (gpu::vec4& l : ledgers) l = {random.between(-3, 6), random.between(0, 6), random.between(-3, 3), 0};
            fill(buffer, ledgers);
            return ledgers;
        };
        const auto pairs = some(fixture.stages.restitution->pairLedgers);
        const auto colliders = some(fixture.stages.restitution->colliderLedgers);
        for (size_t q = 0; q < fixture.pairs.size(); ++q) {
            const Vector3d l = vec3(pairs[q]).cast<double>();
            purses[fixture.moverOf[fixture.pairs[q].first]].ledger += l;
            purses[fixture.moverOf[fixture.pairs[q].second]].ledger += l.cwiseProduct(Vector3d(1, 1, -1));
        }
        for (size_t q = 0; q < fixture.colliderContacts.size(); ++q)
            purses[fixture.moverOf[fixture.colliderContacts[q].first]].ledger += vec3(colliders[q]).cast<double>();
        for (uint32_t m = 0; m < fixture.moverCount(); ++m) addEnergies(purses[m], m);
    }
    double energyOf(uint32_t m, const Field& v) const
    {
        const double linear = 0.5 * fixture.masses[m] * v.t.squaredNorm();
        if (!fixture.isBody(m)) return linear;
        return linear +
               0.5 * (v.f * bodyMass(fixture.world, fixture.world.bodies[m]).moments * v.f.transpose()).trace();
    }
    void addEnergies(Purse& purse, uint32_t m) const
    {
        const Field before = fixture.field(fixture.before.fields, m), solved = fixture.field(fixture.solved.fields, m);
        const Vector3d pull = fixture.h() * fixture.gravity();
        const double fall = fixture.masses[m] * fixture.gravity().dot(fixture.field(fixture.ways, m).t);
        purse.budget = energyOf(m, before) - energyOf(m, solved) + purse.ledger.z() + fall;
        purse.push = energyOf(m, {solved.t - before.t - pull, solved.f - before.f});
        purse.error = 64 * EPSILON * (energyOf(m, before) + energyOf(m, solved) + purse.ledger.norm() + std::abs(fall));
    }
    bool isJointed(uint32_t m) const
    {
        if (!fixture.isBody(m)) return false;
        for (const Part& part : fixture.parts[m])
            if (fixture.world.particles[part.particle].bodyCount > 1) return true;
        return false;
    }

    std::vector<Purse> purses;
};

/// The largest share whose gain is within a budget, by bisection.
double largestShare(const Vector3d& ledger, double budget)
{
    const auto gain = [&](double s) { return s * ledger.x() + s * s * ledger.y(); };
    if (gain(1.0) <= budget) return 1.0;
    double low = 0.0, high = 1.0;
    for (int k = 0; k < 60; ++k) {
        const double middle = 0.5 * (low + high);
        (gain(middle) <= budget ? low : high) = middle;
    }
    return low;
}

TEST_F(MoverShare, TheGainIsWithinWhatTheSubstepTook)
{
    fixture.forMovers("restitution/mover_share");
    const auto found = fixture.stages.restitution->moverRestitutionShares.download();
    uint32_t whole = 0, part = 0, nothing = 0, jointed = 0;
    for (uint32_t m = 0; m < fixture.moverCount(); ++m) {
        if (fixture.isFixed(m)) {
            ASSERT_EQ(found[m].x, fixture.shares[m].x) << "mover " << m;
            continue;
        }
        if (isJointed(m)) {
            ASSERT_EQ(found[m].x, 1.0f) << "mover " << m << ": joints carry energy to other bodies";
            ASSERT_EQ(found[m].y, 1.0f) << "mover " << m;
            ++jointed;
            continue;
        }
        const Purse& p = purses[m];
        const double budget = std::max(p.budget, 0.0), share = largestShare(p.ledger, budget);
        // The share changes with the budget by one over the slope of the gain there; without a budget by its root.
        const double slope = std::abs(p.ledger.x() + 2 * share * p.ledger.y());
        const double tolerance = 8 * EPSILON + std::min(p.error / std::max(slope, 1e-20), std::sqrt(p.error));
        ASSERT_NEAR(found[m].x, share, tolerance) << "mover " << m;
        const double solvers = std::clamp(1.0 + p.budget / p.push, 0.0, 1.0);
        ASSERT_NEAR(found[m].y, solvers, 8 * EPSILON + 4 * p.error / p.push) << "mover " << m;
        ++(share == 1.0 ? whole : share == 0.0 ? nothing : part);
    }
    for (uint32_t met : {whole, part, nothing}) EXPECT_GT(met, 10u);
    EXPECT_GT(jointed, 8u);
}

TEST_F(MoverShare, WhatDoesNotCollideKeepsAllOfIt)
{
    fill(fixture.stages.restitution->moverRestitutionSplits, std::vector<float>(fixture.moverCount(), 0.0f));
    fixture.forMovers("restitution/mover_share");
    const auto found = fixture.stages.restitution->moverRestitutionShares.download();
    for (uint32_t m = 0; m < fixture.moverCount(); ++m) {
        if (fixture.isFixed(m)) continue;
        ASSERT_EQ(found[m].x, 1.0f) << "mover " << m;
        ASSERT_EQ(found[m].y, 1.0f) << "mover " << m;
    }
}

}  // namespace

}  // namespace knuckle::test
