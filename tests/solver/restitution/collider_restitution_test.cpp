#include "tests/solver/restitution/restitution_fixture.h"

namespace knuckle::test {

namespace {

class ColliderRestitution : public Restitution {
protected:
    void run(const Defines& defines)
    {
        fixture.run("restitution/collider_restitution", fixture.colliderContacts.size(), defines);
    }
    void expectIteration(bool eager)
    {
        run(eager ? Defines{{"EAGER", "1"}} : Defines{});
        expectBounces(fixture.colliderRestitutions(), [&](size_t q) {
            const TestContact& c = fixture.colliderContacts[q];
            const double inverseMass = fixture.splits[fixture.moverOf[c.first]] * c.firstMass * c.firstFraction;
            return bounceOf(fixture.ofCollider(c), fixture.lastColliders[q], fixture.restitution(c.first), inverseMass,
                            eager);
        });
    }
};

TEST_F(ColliderRestitution, WhatMeetsFastWhileItCarriesWillActAndNothingElse)
{
    run({{"DETECT", "1"}});
    expectDetection(
        fixture.colliderRestitutions(), fixture.colliderContacts,
        [&](const TestContact& c) { return fixture.ofCollider(c); },
        [&](const TestContact& c) { return fixture.restitution(c.first); }, 50);
}

TEST_F(ColliderRestitution, AnIterationGivesWhatIsMissingToTheSpeedOfParting)
{
    expectIteration(false);
}

TEST_F(ColliderRestitution, AnEagerIterationGivesMore)
{
    expectIteration(true);
}

TEST_F(ColliderRestitution, TheLedgerGivesTheMoverAllOfTheEnergy)
{
    run({{"LEDGER", "1"}});
    const auto found = fixture.stages.restitution->colliderLedgers.download();
    for (size_t q = 0; q < fixture.colliderContacts.size(); ++q) {
        const Collision s = fixture.ofCollider(fixture.colliderContacts[q]);
        if (!s.sure) continue;
        const double impulse = std::max(fixture.lastColliders[q].w, 0.0f), tolerance = impulse * s.speedError + 1e-12;
        ASSERT_NEAR(found[q].x, impulse * s.solved, tolerance) << "contact " << q;
        ASSERT_NEAR(found[q].y, impulse * (s.now - s.solved) / 2, tolerance) << "contact " << q;
        ASSERT_EQ(found[q].z, 0.0f) << "contact " << q;
    }
}

TEST_F(ColliderRestitution, ImpulsesAreScaledToWhatTheMoverAffords)
{
    run({{"SHARE", "1"}});
    const auto found = fixture.colliderRestitutions();
    for (size_t q = 0; q < found.size(); ++q) {
        const TestContact& c = fixture.colliderContacts[q];
        const Collision s = fixture.ofCollider(c);
        const gpu::vec4 share = fixture.shares[fixture.moverOf[c.first]];
        const double sum = std::max(fixture.lastColliders[q].w, 0.0f);
        const Vector3d solver = vec3(c.impulse).cast<double>() / fixture.h();
        const Vector3d wanted = (double(share.x) - 1) * sum * s.normal + (double(share.y) - 1) * solver;
        ASSERT_NEAR(found[q].w, share.x * sum, 4 * EPSILON * sum) << "contact " << q;
        ASSERT_LE((vec3(found[q]).cast<double>() - wanted).norm(),
                  s.turnError * sum + 16 * EPSILON * (sum + solver.norm()))
            << "contact " << q;
    }
}

}  // namespace

}  // namespace knuckle::test
