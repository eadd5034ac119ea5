#include "tests/solver/body/mover_solve_fixture.h"

namespace knuckle::test {

namespace {

TEST_F(MoverSolve, SumsTheImpulsesOfContactsWithTheirSides)
{
    solveAll();
    const auto found = fixture.stages.bodies.moverImpulses.download();
    uint32_t loaded = 0;
    for (uint32_t m = 0; m < fixture.moverCount(); ++m) {
        if (fixture.isFixed(m)) continue;
        // Each of n additions rounds by 2^-24 of at most the sum of the sizes.
        const double rounding = EPSILON * (counts[m] + 2) * sizes[m];
        const Field sum = fixture.field(found, m);
        EXPECT_LE((sum.t - sums[m].t).norm(), rounding) << "mover " << m;
        EXPECT_LE((sum.f - sums[m].f).norm(), rounding * fixture.radius(m)) << "mover " << m;
        loaded += sizes[m] > 0.0;
    }
    EXPECT_GT(loaded, fixture.moverCount() / 2);
}

TEST_F(MoverSolve, MoversGoWhereTheImpulsesOfContactsAndRowsBringThem)
{
    solveAll();
    for (uint32_t m = 0; m < fixture.moverCount(); ++m) {
        SCOPED_TRACE("mover " + std::to_string(m));
        if (fixture.isFixed(m)) continue;
        const Field rows = rowImpulse(m);
        const Field whole{sums[m].t + rows.t, sums[m].f + rows.f};
        const double splits = counts[m] / double(wantedRelaxation(m));
        expectMatch(m, whole, sizes[m] + 0.004 * rowCount(m), splits);
    }
}

TEST_F(MoverSolve, TheRelaxationFollowsHowTheSumsChange)
{
    solveAll();
    const auto found = fixture.stages.bodies.moverChanges.download();
    for (uint32_t m = 0; m < fixture.moverCount(); ++m) {
        if (fixture.isFixed(m)) continue;
        EXPECT_FLOAT_EQ(found[fixture.fieldStart(m)].w, wantedRelaxation(m)) << "mover " << m << ", " << ratios[m];
        const Field change = fixture.field(found, m), old = fixture.field(oldSums, m);
        // Of two rounded sums.
        const double rounding = EPSILON * (counts[m] + 4) * (sizes[m] + old.t.norm());
        EXPECT_LE((change.t - (sums[m].t - old.t)).norm(), rounding) << "mover " << m;
    }
}

TEST_F(MoverSolve, AfterASearchItTakesTheOldImpulsesAndLearnsNothing)
{
    solveAll({{"WARM_START", "1"}});
    const auto found = fixture.stages.bodies.moverChanges.download();
    for (uint32_t m = 0; m < fixture.moverCount(); ++m) {
        SCOPED_TRACE("mover " + std::to_string(m));
        if (fixture.isFixed(m)) continue;
        const Field rows = rowImpulse(m);
        const Field whole{sums[m].t + rows.t, sums[m].f + rows.f};
        expectMatch(m, whole, sizes[m] + 0.004 * rowCount(m), counts[m] / double(relaxations[m]));
        EXPECT_EQ(found[fixture.fieldStart(m)].w, relaxations[m]);
        EXPECT_EQ(fixture.field(found, m).t, fixture.field(changes, m).t);
    }
}

TEST_F(MoverSolve, BeforeTheFirstSolveEachRowCountsAsAnImpulse)
{
    gpu::Counters now = fixture.counters();
    now.substep = 1;  // search_due has counted it
    fixture.setCounters(now);
    solveAll({{"WARM_START", "1"}});
    const auto moves = fixture.stages.bodies.moverMoves.download();
    for (uint32_t m = 0; m < fixture.moverCount(); ++m) {
        if (fixture.isFixed(m)) continue;
        EXPECT_FLOAT_EQ(moves[m].w, static_cast<float>((counts[m] + rowCount(m)) / double(relaxations[m])));
    }
}

TEST_F(MoverSolve, AssembliesThatContactsPushAreStampedAndOthersAreNot)
{
    solveAll();
    const auto infos = fixture.stages.bodies.moverInfo.download();
    const auto states = fixture.stages.particles.assemblyState.download();
    std::vector<bool> pushed(states.size());
    for (uint32_t m = 0; m < fixture.moverCount(); ++m)
        if (!fixture.isFixed(m) && sizes[m] > 0.0) pushed[infos[m].assembly] = true;
    for (size_t k = 0; k < states.size(); ++k)
        EXPECT_EQ(states[k].x, pushed[k] ? MoverFixture::SUBSTEP - 1 : 0x7fffffffu) << "assembly " << k;
    EXPECT_GT(std::count(pushed.begin(), pushed.end(), true), 100);
    EXPECT_GT(std::count(pushed.begin(), pushed.end(), false), 100);
}

TEST_F(MoverSolve, FixedBodiesStay)
{
    solveAll();
    const auto moves = fixture.stages.bodies.moverMoves.download(),
               turns = fixture.stages.bodies.moverRotationDeltas.download();
    for (uint32_t m = 0; m < fixture.moverCount(); ++m) {
        if (!fixture.isFixed(m)) continue;
        EXPECT_EQ(vec3(moves[m]), vec3(fixture.moves[m]));
        EXPECT_EQ(vec3(turns[m]), vec3(fixture.turns[m]));
    }
}

/// The first of a pair gets exactly what the second loses, so momentum is kept.
TEST_F(MoverSolve, APairsImpulsesOnItsTwoMoversCancelExactly)
{
    std::vector<TestContact> pairs;
    Random random(117);
    for (uint32_t m = 0; m + 1 < fixture.moverCount(); m += 2) {
        const Part &a = anyPart(m, random), &b = anyPart(m + 1, random);
        if (fixture.moverOf[a.particle] != m || fixture.moverOf[b.particle] != m + 1) continue;
        if (fixture.isFixed(m) || fixture.isFixed(m + 1)) continue;
        TestContact c{.first = a.particle, .second = b.particle, .firstArm = a.r.cast<float>()};
        const Vector3f apart = 0.98f * DIAMETER * random.direction();
        c.secondArm = fixture.armTo(b.particle, fixture.place(a.particle, c.firstArm).cast<float>() + apart);
        c.firstMass = 1 / static_cast<float>(fixture.masses[m]);
        c.secondMass = 1 / static_cast<float>(fixture.masses[m + 1]);
        c.staticFriction = c.kineticFriction = 0.5f;
        c.impulse.w = ABOUT_TO_ACT;
        pairs.push_back(c);
    }
    fixture.setColliderContacts({});
    fixture.setPairs(pairs);
    fixture.run("contact/contact_solve", pairs.size());
    solveAll();
    const auto sum = fixture.stages.bodies.moverImpulses.download();
    uint32_t acting = 0;
    for (const TestContact& c : fixture.pairs) {
        const gpu::vec4 a = sum[fixture.fieldStart(fixture.moverOf[c.first])];
        const gpu::vec4 b = sum[fixture.fieldStart(fixture.moverOf[c.second])];
        EXPECT_EQ(vec3(a), Vector3f(-vec3(b))) << "particles " << c.first << " and " << c.second;
        acting += vec3(a) != Vector3f::Zero();
    }
    EXPECT_GT(acting, 100u);
}

}  // namespace

}  // namespace knuckle::test
