#include "tests/solver/contact/contact_solve_fixture.h"

namespace knuckle::test {

namespace {

TEST_F(ContactSolve, PairsGetTheImpulseOfTheReference)
{
    makePairs();
    fixture.run("contact/contact_solve", fixture.pairs.size());
    expectAnswers(fixture.pairs, fixture.pairImpulses(), fixture.pairMeans(),
                  [&](const TestContact& c) { return ofPair(c); });
}

TEST_F(ContactSolve, WhatHasSunkIsHeldByNoMoreThanRecoveryPushes)
{
    makePairs(0.05f);
    fixture.run("contact/contact_solve", fixture.pairs.size());
    const auto found = fixture.pairImpulses();
    expectAnswers(fixture.pairs, found, fixture.pairMeans(), [&](const TestContact& c) { return ofPair(c); });
    uint32_t pulling = 0;
    for (size_t q = 0; q < found.size(); ++q) {
        const TestContact& c = fixture.pairs[q];
        const Situation s = ofPair(c);
        const double pull = -vec3(found[q]).cast<double>().dot(s.normal);
        const double size = vec3(found[q]).cast<double>().norm();
        const bool mayPull = !c.kin && s.startGap < (SUNK - 1) * DIAMETER && c.impulse.w != 0.0f;
        // The bound itself cuts it off; the normal is off by 1e-5 (see below).
        ASSERT_LE(pull, (mayPull ? step().maxCorrection / s.inverseMass : 0.0) + 1e-5 * size + 1e-12) << "pair " << q;
        pulling += pull > 1e-4 * size;
    }
    EXPECT_GT(pulling, 100u);
}

TEST_F(ContactSolve, ContactsWithCollidersGetTheImpulseOfTheReference)
{
    makeColliderContacts();
    fixture.run("contact/collider_solve", fixture.colliderContacts.size());
    expectAnswers(fixture.colliderContacts, fixture.colliderImpulses(), fixture.colliderMeans(),
                  [&](const TestContact& c) { return ofCollider(c); });
}

TEST_F(ContactSolve, ImpulsesNeverPullAndStayInTheConeOfFriction)
{
    makePairs();
    for (int k = 0; k < 5; ++k) fixture.run("contact/contact_solve", fixture.pairs.size());
    const auto found = fixture.pairImpulses();
    for (size_t q = 0; q < found.size(); ++q) {
        const TestContact& c = fixture.pairs[q];
        const Vector3d p = vec3(found[q]).cast<double>(), n = ofPair(c).normal;
        const double normal = std::max(double(found[q].w), 0.0);
        // The normal is off by a ten thousandth of a degree (places of half a metre over a diameter).
        ASSERT_NEAR(p.dot(n), normal, 1e-5 * p.norm() + 1e-12) << "pair " << q;
        ASSERT_LE((p - n * p.dot(n)).norm(), c.staticFriction * normal + 1e-5 * p.norm()) << "pair " << q;
    }
}

TEST_F(ContactSolve, AnOldPenetrationIsTakenBackByItsShareAndNoFasterThanTheBound)
{
    fixture.setMoves(0, 0, SPLITS);
    makePairs();
    auto resting = fixture.pairs;
    for (TestContact& c : resting) c.impulse = {0, 0, 0, ABOUT_TO_ACT};
    fixture.setPairs(resting);
    fixture.run("contact/contact_solve", resting.size());
    const auto found = fixture.pairImpulses();
    uint32_t bounded = 0, shared = 0;
    for (size_t q = 0; q < found.size(); ++q) {
        const Situation s = ofPair(fixture.pairs[q]);
        if (s.startGap > -1e-4) continue;
        // How far the impulse moves both sides apart.
        const double apart = found[q].w * s.inverseMass, share = -step().correction * s.startGap;
        const double most = step().maxCorrection * (s.kin ? LIMB_RECOVERY : 1.0f);
        EXPECT_NEAR(apart, std::min(share, most), 2e-6) << "pair " << q;
        EXPECT_LT(vec3(found[q]).cross(s.normal.cast<float>()).norm() * s.worstMass, 2e-6) << "no friction at rest";
        ++(share > most ? bounded : shared);
    }
    EXPECT_GT(bounded, 100u);
    EXPECT_GT(shared, 100u);
}

}  // namespace

}  // namespace knuckle::test
