#include <cmath>

#include "sim/solver/layout/body_mass.h"
#include "tests/solver/restitution/restitution_fixture.h"

namespace knuckle::test {

namespace {

/// Everything that acts on a mover: its impulses with their arms in its axes, in all lists.
struct Acting {
    Vector3d impulse = Vector3d::Zero();
    Vector3d torque = Vector3d::Zero();  ///< In the world's axes.
    double size = 0.0, turnSize = 0.0;
    uint32_t count = 0;
};

class MoverRestitution : public Restitution {
protected:
    MoverRestitution() : acting(fixture.moverCount())
    {
        for (size_t q = 0; q < fixture.pairs.size(); ++q) {
            const TestContact& c = fixture.pairs[q];
            add(c.first, c.firstArm, fixture.lastPairs[q], 1);
            add(c.second, c.secondArm, fixture.lastPairs[q], -1);
        }
        for (size_t q = 0; q < fixture.colliderContacts.size(); ++q)
            add(fixture.colliderContacts[q].first, fixture.colliderContacts[q].firstArm, fixture.lastColliders[q], 1);
    }
    void add(uint32_t particle, const Vector3f& r, const gpu::vec4& impulse, double side)
    {
        const uint32_t m = fixture.moverOf[particle];
        const Vector3d p = side * vec3(impulse).cast<double>(), arm = fixture.armOf(m, r);
        acting[m].impulse += p;
        acting[m].torque += arm.cross(p);
        acting[m].size += p.norm();
        acting[m].turnSize += p.norm() * arm.norm();
        acting[m].count += impulse.w != 0.0f;
    }

    std::vector<Acting> acting;
};

TEST_F(MoverRestitution, ItsMassIsSplitOverTheContactsThatWillAct)
{
    RestitutionStage& stage = *fixture.stages.restitution;
    fill(stage.moverRestitutionSplits, std::vector<float>(fixture.moverCount(), 0.0f));
    fixture.forMovers("restitution/mover_restitution", {{"DETECT", "1"}});
    const auto splits = stage.moverRestitutionSplits.download();
    uint32_t many = 0, none = 0;
    for (uint32_t m = 0; m < fixture.moverCount(); ++m) {
        const double wanted = fixture.isFixed(m) ? 0 : acting[m].count;
        ASSERT_EQ(splits[m], wanted) << "mover " << m;
        many += wanted > 3;
        none += wanted == 0;
    }
    EXPECT_GT(many, 50u);
    EXPECT_GT(none, 20u);
}

TEST_F(MoverRestitution, BouncesRunInSubstepsInWhichAnythingCollides)
{
    RestitutionStage& stage = *fixture.stages.restitution;
    std::vector<gpu::uvec4> dispatches(DISPATCH_COUNT);
    dispatches[DISPATCH_PAIRS].x = 5;
    dispatches[DISPATCH_COLLIDER_PAIRS].x = 3;
    fill(fixture.stages.dispatches, dispatches);
    const auto sizesAfter = [&](uint32_t substep) {
        gpu::Counters counters = fixture.counters();
        counters.substep = substep;
        fixture.setCounters(counters);
        fixture.forMovers("restitution/mover_restitution", {{"DETECT", "1"}});
        fixture.run("restitution/restitution_due", 1);
        return stage.restitutionSizes.download();
    };
    const auto collide = sizesAfter(7);
    EXPECT_EQ(collide[RESTITUTION_PAIRS_SIZE].x, 5u);
    EXPECT_EQ(collide[RESTITUTION_COLLIDER_PAIRS_SIZE].x, 3u);
    EXPECT_EQ(collide[RESTITUTION_MOVERS_SIZE].x, groupsFor(fixture.moverCount()));
    fill(stage.pairRestitutions, std::vector<gpu::vec4>(stage.pairRestitutions.size(), gpu::vec4{}));
    fill(stage.colliderRestitutions, std::vector<gpu::vec4>(stage.colliderRestitutions.size(), gpu::vec4{}));
    for (const gpu::uvec4& size : sizesAfter(8)) EXPECT_EQ(size.x, 0u);
}

TEST_F(MoverRestitution, ImpulsesChangeVelocitiesByMassAndInertia)
{
    fixture.forMovers("restitution/mover_restitution");
    const auto found = fixture.stages.bodies.moverVelocities.download();
    for (uint32_t m = 0; m < fixture.moverCount(); ++m) {
        const Field was = fixture.field(fixture.now.fields, m), is = fixture.field(found, m);
        const Acting& a = acting[m];
        if (fixture.isFixed(m)) {
            ASSERT_EQ(is.t, was.t) << "mover " << m;
            ASSERT_EQ(is.f, was.f) << "mover " << m;
            continue;
        }
        // Sums of up to a hundred impulses.
        const double roundings = 64 * EPSILON, inverseMass = 1 / fixture.masses[m];
        ASSERT_LE((is.t - was.t - a.impulse * inverseMass).norm(), roundings * (was.t.norm() + a.size * inverseMass))
            << "mover " << m;
        if (!fixture.isBody(m)) continue;
        const Matrix3d axes = fixture.rotation(m).toRotationMatrix();
        const Matrix3d inverse = axes * bodyMass(fixture.world, fixture.world.bodies[m]).inverseInertia *
                                 axes.transpose();
        const Vector3d spin = inverse * a.torque;
        for (int c = 0; c < 3; ++c) {
            const Vector3d wanted = was.f.col(c) + spin.cross(axes.col(c));
            ASSERT_LE((is.f.col(c) - wanted).norm(), roundings * (was.f.norm() + inverse.norm() * a.turnSize))
                << "mover " << m;
        }
    }
}

/// What was passed on is taken back of its place, too, and then its velocity without bounces is noted.
TEST_F(MoverRestitution, WhatIsTakenBackChangesItsPlaceAndTheVelocityThatIsKept)
{
    const auto before = fixture.stages.bodies.moverCentres.download();
    fixture.forMovers("restitution/mover_restitution", {{"BEGIN", "1"}});
    const auto found = fixture.stages.bodies.moverVelocities.download();
    const auto kept = fixture.stages.restitution->moverSolvedVelocities.download();
    const auto centres = fixture.stages.bodies.moverCentres.download();
    const double h = fixture.stages.parameters.substepTime;
    double moved = 0.0;
    for (uint32_t m = 0; m < fixture.moverCount(); ++m) {
        const Field was = fixture.field(fixture.now.fields, m), is = fixture.field(found, m);
        const Vector3d shift = (vec3(centres[m]) - vec3(before[m])).cast<double>();
        const Vector3d wanted = fixture.isFixed(m) ? Vector3d(0, 0, 0) : Vector3d(h * (is.t - was.t));
        ASSERT_LE((shift - wanted).norm(), 1e-6) << "mover " << m;  // a rounding of a place of some metres
        moved += wanted.norm();
        if (fixture.isFixed(m)) continue;
        ASSERT_EQ(fixture.field(kept, m).t, is.t) << "mover " << m;
        ASSERT_EQ(fixture.field(kept, m).f, is.f) << "mover " << m;
    }
    EXPECT_GT(moved, 1e-3);
}

/// The closed form: for a single collision, one iteration gives the speed of parting, and momentum is kept.
TEST_F(MoverRestitution, ASingleCollisionPartsWithItsShareOfTheSpeedOfApproach)
{
    // Two loose particles that meet head on.
    const auto first = static_cast<uint32_t>(fixture.world.particles.size()) - 3, second = first + 1;
    TestContact c{.first = first,
                  .second = second,
                  .firstMass = 1 / fixture.world.particles[first].mass,
                  .secondMass = 1 / fixture.world.particles[second].mass,
                  .impulse = {0, 0, 0, 1e-3f}};
    fixture.setPairs({c});
    fixture.setColliderContacts({});
    RestitutionStage& stage = *fixture.stages.restitution;
    const gpu::uvec2 both{first, second};
    fixture.stages.search.pairs.write(&both, sizeof both, fixture.stages.search.pairs.size() / 2 * sizeof both);
    Velocities& v = fixture.before;
    const uint32_t a = fixture.moverOf[first], b = fixture.moverOf[second];
    const Vector3d normal = (fixture.centre(a) - fixture.centre(b)).normalized();
    v.fields[fixture.fieldStart(a)] = packed(Vector3f(-2.0f * normal.cast<float>()));
    v.fields[fixture.fieldStart(b)] = packed(Vector3f(1.0f * normal.cast<float>()));
    fill(fixture.stages.bodies.oldMoverVelocities, v.fields);
    // The solve has stopped them.
    fill(fixture.stages.bodies.moverVelocities, std::vector<gpu::vec4>(v.fields.size(), gpu::vec4{0, 0, 0, 0}));
    fill(stage.moverRestitutionSplits, std::vector<float>(fixture.moverCount(), 0.0f));
    for (const Defines& variant : {Defines{{"DETECT", "1"}}, Defines{}}) {
        fixture.run("restitution/contact_restitution", 1, variant);
        fixture.forMovers("restitution/mover_restitution", variant);
    }
    const auto found = fixture.stages.bodies.moverVelocities.download();
    const Vector3d va = fixture.field(found, a).t, vb = fixture.field(found, b).t;
    const double restitution = std::max(fixture.restitution(first), fixture.restitution(second));
    ASSERT_GT(restitution, 0.1);
    EXPECT_NEAR(normal.dot(va - vb), 3.0 * restitution, 1e-5);
    EXPECT_LT((fixture.masses[a] * va + fixture.masses[b] * vb).norm(), 1e-6 * fixture.masses[a]);
}

}  // namespace

}  // namespace knuckle::test
