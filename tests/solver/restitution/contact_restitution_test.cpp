#include "tests/solver/restitution/restitution_fixture.h"

namespace knuckle::test {

namespace {

class ContactRestitution : public Restitution {
protected:
    void run(const Defines& defines) { fixture.run("restitution/contact_restitution", fixture.pairs.size(), defines); }
    double restitutionOf(const TestContact& c) const
    {
        return std::max(fixture.restitution(c.first), fixture.restitution(c.second));
    }
    /// The inverse mass for an impulse along the normal, with each side's mass split over its impulses.
    double inverseMass(const TestContact& c) const
    {
        return fixture.splits[fixture.moverOf[c.first]] * c.firstMass * c.firstFraction +
               fixture.splits[fixture.moverOf[c.second]] * c.secondMass * c.secondFraction;
    }
    bool hasFixed(const TestContact& c) const
    {
        return fixture.isFixed(fixture.moverOf[c.first]) || fixture.isFixed(fixture.moverOf[c.second]);
    }
};

TEST_F(ContactRestitution, WhatMeetsFastWhileItCarriesWillActAndNothingElse)
{
    run({{"DETECT", "1"}});
    expectDetection(
        fixture.pairRestitutions(), fixture.pairs, [&](const TestContact& c) { return fixture.ofPair(c); },
        [&](const TestContact& c) { return restitutionOf(c); }, 100);
}

TEST_F(ContactRestitution, AnIterationGivesWhatIsMissingToTheSpeedOfParting)
{
    run({});
    expectBounces(fixture.pairRestitutions(), [&](size_t q) {
        const TestContact& c = fixture.pairs[q];
        return bounceOf(fixture.ofPair(c), fixture.lastPairs[q], restitutionOf(c), inverseMass(c), false);
    });
}

TEST_F(ContactRestitution, AnEagerIterationGivesMore)
{
    run({{"EAGER", "1"}});
    expectBounces(fixture.pairRestitutions(), [&](size_t q) {
        const TestContact& c = fixture.pairs[q];
        return bounceOf(fixture.ofPair(c), fixture.lastPairs[q], restitutionOf(c), inverseMass(c), true);
    });
}

/// An impulse J that changes a relative velocity from u to w has done J (u + w) / 2; s of it, s J (u + s (w - u) / 2).
TEST_F(ContactRestitution, TheLedgerHasWhatTheImpulsesGiveAndWhatOneSideTookFromTheOther)
{
    run({{"LEDGER", "1"}});
    const auto found = fixture.stages.restitution->pairLedgers.download();
    uint32_t fixed = 0;
    for (size_t q = 0; q < fixture.pairs.size(); ++q) {
        const TestContact& c = fixture.pairs[q];
        const Collision s = fixture.ofPair(c);
        if (!s.sure) continue;
        const uint32_t a = fixture.moverOf[c.first], b = fixture.moverOf[c.second];
        const double impulse = std::max(fixture.lastPairs[q].w, 0.0f), part = hasFixed(c) ? 1.0 : 0.5;
        const double tolerance = impulse * s.speedError;
        ASSERT_NEAR(found[q].x, part * impulse * s.solved, tolerance + 1e-12) << "pair " << q;
        ASSERT_NEAR(found[q].y, part * impulse * (s.now - s.solved) / 2, tolerance + 1e-12) << "pair " << q;
        fixed += hasFixed(c);
        // The effect of the solver's impulse on a side that begins with gravity's part, and on the other.
        const Vector3d solver = vec3(c.impulse).cast<double>() / fixture.h(), pull = fixture.h() * fixture.gravity();
        const auto work = [&](uint32_t m, const Vector3f& r) {
            const Vector3d at = fixture.armOf(m, r);
            return solver.dot(fixture.before.known[m].at(at) + pull + fixture.solved.known[m].at(at)) / 2;
        };
        // The work on both is taken from both equally: half of their difference is the first side's excess.
        const double wanted = hasFixed(c) ? 0.0 : (work(a, c.firstArm) + work(b, c.secondArm)) / 2;
        ASSERT_NEAR(found[q].z, wanted, solver.norm() * s.speedError + 1e-12) << "pair " << q;
    }
    EXPECT_GT(fixed, 20u);
}

TEST_F(ContactRestitution, ImpulsesAreScaledToWhatThePoorerSideAffords)
{
    run({{"SHARE", "1"}});
    const auto found = fixture.pairRestitutions();
    uint32_t alone = 0;
    for (size_t q = 0; q < found.size(); ++q) {
        const TestContact& c = fixture.pairs[q];
        const Collision s = fixture.ofPair(c);
        if (!s.sure) continue;
        double ours = 1.0, solvers = 1.0;
        for (uint32_t particle : {c.first, c.second}) {
            const uint32_t m = fixture.moverOf[particle];
            if (!fixture.responds(m) && ++alone) continue;  // fixed movers afford everything
            ours = std::min(ours, static_cast<double>(fixture.shares[m].x));
            solvers = std::min(solvers, static_cast<double>(fixture.shares[m].y));
        }
        const double sum = std::max(fixture.lastPairs[q].w, 0.0f);
        const Vector3d solver = vec3(c.impulse).cast<double>() / fixture.h();
        const Vector3d wanted = (ours - 1) * sum * s.normal + (solvers - 1) * solver;
        ASSERT_NEAR(found[q].w, ours * sum, 4 * EPSILON * sum) << "pair " << q;
        ASSERT_LE((vec3(found[q]).cast<double>() - wanted).norm(),
                  s.turnError * sum + 16 * EPSILON * (sum + solver.norm()))
            << "pair " << q;
    }
    EXPECT_GT(alone, 20u);
}

}  // namespace

}  // namespace knuckle::test
