#include <algorithm>

#include "sim/solver/layout/layout.h"
#include "tests/solver/solver_test.h"

namespace knuckle::test {

namespace {

/// Needs no GPU: a Layout is made from the World alone.
class WorldLayout : public testing::Test {
protected:
    World world = mixedWorld();
    Layout layout{world};
};

TEST_F(WorldLayout, ParticlesRankByMoverAndThenByIndex)
{
    ASSERT_EQ(layout.rankedParticles.size(), world.particles.size());
    for (uint32_t rank = 0; rank < layout.solidCount; ++rank) {
        const uint32_t particle = layout.rankedParticles[rank];
        ASSERT_EQ(layout.ranks[particle].rank, rank);
        if (rank == 0) continue;
        const uint32_t before = layout.rankedParticles[rank - 1];
        ASSERT_LE(layout.ranks[before].mover, layout.ranks[particle].mover);
        if (layout.ranks[before].mover == layout.ranks[particle].mover) {
            ASSERT_LT(before, particle);
        }
    }
    for (uint32_t m = 0; m < layout.moverCount(); ++m)
        for (uint32_t k = 0; k < layout.moverRanks[m].y; ++k)
            ASSERT_EQ(layout.ranks[layout.rankedParticles[layout.moverRanks[m].x + k]].mover, m);
}

TEST_F(WorldLayout, ABodysSharedLinksComeLast)
{
    uint32_t joints = 0;
    for (uint32_t b = 0; b < world.bodies.size(); ++b) {
        const Body& body = world.bodies[b];
        for (uint32_t k = 0; k < body.linkCount; ++k) {
            const uint32_t l = body.linkStart + k;
            const Link& link = world.links[layout.linkOrder[l]];
            const bool shared = world.particles[link.particle].bodyCount > 1;
            ASSERT_EQ(link.body, b);
            ASSERT_EQ(shared, k >= layout.ownLinkCounts[b]) << "link " << l;
            joints += shared;
        }
    }
    EXPECT_GT(joints, 30u);
}

TEST_F(WorldLayout, SharedParticlesOfFewerBodiesComeFirst)
{
    ASSERT_EQ(layout.sharedParticles.size(), 17u);
    for (size_t k = 0; k < layout.sharedParticles.size(); ++k)
        EXPECT_EQ(layout.owners[layout.sharedParticles[k]].size(), k < 16 ? 2u : 3u);
}

TEST_F(WorldLayout, JointsReserveARowForEachBodyThatCanMove)
{
    RowPlan plan;
    JointStage::reserveRows(plan, world, layout);
    plan.place(layout.bodyCount);
    const std::vector<uint32_t> rows = plan.rowsOf("joint");
    ASSERT_EQ(rows.size(), plan.arms().size());
    size_t next = 0;
    const auto expectRow = [&](uint32_t body, const Vector3f& arm) {
        if (world.bodies[body].motion == Motion::Fixed) return;
        const uint32_t row = rows.at(next++);
        EXPECT_EQ(plan.arms()[row], arm);
        EXPECT_GE(row, plan.bodies()[body].x);
        EXPECT_LT(row, plan.bodies()[body].x + plan.bodies()[body].y);
    };
    for (const JointTrees::Joint& joint : layout.jointTrees.all()) {
        if (joint.parent == NO_INDEX) continue;
        expectRow(joint.body, joint.side.arm);
        expectRow(joint.parent, joint.parentSide.arm);
    }
    EXPECT_EQ(next, rows.size());
    // A pair of each kind, the universal joint of two hinges, one that overlaps, and one of which half is fixed.
    EXPECT_EQ(next, 2u * 6 + 1);
}

TEST(RowPlan, RowsOfABodyStandTogetherInTheOrderOfReservation)
{
    RowPlan plan;
    plan.reserve("joint", 2, {1, 0, 0});
    plan.reserve("spring", 0, {2, 0, 0});
    plan.reserve("spring", 2, {3, 0, 0});
    plan.place(4);
    EXPECT_EQ(plan.rowsOf("joint"), std::vector<uint32_t>{1});
    EXPECT_EQ(plan.rowsOf("spring"), (std::vector<uint32_t>{0, 2}));
    EXPECT_TRUE(plan.rowsOf("rope").empty());
    EXPECT_EQ(plan.arms()[2].x(), 3.0f);
    EXPECT_EQ(plan.bodies()[2].x, 1u);
    EXPECT_EQ(plan.bodies()[2].y, 2u);
    EXPECT_EQ(plan.bodies()[1].y + plan.bodies()[3].y, 0u);
}

TEST(RowPlan, OneAngularRowTellsThatThereAreAny)
{
    RowPlan plan;
    plan.reserve("joint", 0, {1, 0, 0});
    EXPECT_FALSE(plan.hasAngular());
    plan.reserveAngular("limit", 1, {0, 2, 0});
    plan.place(2);
    EXPECT_TRUE(plan.hasAngular());
    EXPECT_EQ(plan.arms()[plan.rowsOf("limit").front()].y(), 2.0f);
}

}  // namespace

}  // namespace knuckle::test
