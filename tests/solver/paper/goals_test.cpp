#include <algorithm>

#include "tests/solver/solver_test.h"

namespace knuckle::test {

namespace {

/// Bodies moved and turned at random since the substep began.
class Goals : public testing::Test {
protected:
    Goals() : fixture(mixedWorld(byThePaper()))
    {
        Stages& b = fixture.stages;
        Random random(71);
        const size_t bodies = fixture.world.bodies.size();
        for (size_t k = 0; k < bodies; ++k) {
            starts.push_back(packed(random.inCube(0.4f)));
            starts.push_back(packed(random.rotation()));
        }
        for (uint32_t k = 0; k < b.parameters.moverCount; ++k) {
            turns.push_back(packed(Quaternionf(Eigen::AngleAxisf(random.between(0, 0.5f), random.direction()))));
            moves.push_back(packed(random.inCube(0.02f)));
        }
        fill(b.paper->bodyStarts, starts);
        fill(b.bodies.moverRotationDeltas, turns);
        fill(b.bodies.moverMoves, moves);
        moved = randomVectors(b.paper->moved.size(), 0.02f, 72);
        fill(b.paper->moved, moved);
        fill(b.particles.positions, randomVectors(b.particles.positions.size(), 0.3f, 73));
    }
    /// Q r + c minus where r was when the substep began (eq. 8).
    Vector3d goalMove(const Link& link) const
    {
        const Quaternionf start = quaternion(starts[2 * link.body + 1]);
        const Vector3d arm = start.cast<double>() * link.restOffset.cast<double>();
        return vec3(moves[link.body]).cast<double>() + quaternion(turns[link.body]).cast<double>() * arm - arm;
    }
    /// The mean of the goals of a particle's bodies; for a loose or fixed one, its own move.
    std::vector<Vector3d> wantedMoves() const
    {
        std::vector<Vector3d> wanted(moved.size(), Vector3d::Zero());
        for (const Link& link : fixture.world.links)
            wanted[link.particle] += goalMove(link) / fixture.world.particles[link.particle].bodyCount;
        for (size_t i = 0; i < wanted.size(); ++i) {
            const Particle& p = fixture.world.particles[i];
            const bool fixed = isFixed(fixture.world, p);
            if (fixed || p.bodyCount == 0) wanted[i] = vec3(moved[i]).cast<double>();
        }
        return wanted;
    }

    KernelFixture fixture;
    std::vector<gpu::vec4> starts, turns, moves, moved;
};

TEST_F(Goals, ParticlesGoToTheMeanOfTheirBodiesGoals)
{
    fixture.forParticles("paper/shape_goals");
    fixture.run("paper/joint_goals", fixture.stages.parameters.sharedCount);
    const auto found = fixture.stages.paper->predicted.download();
    const auto wanted = wantedMoves();
    uint32_t shared = 0;
    for (size_t i = 0; i < found.size(); ++i) {
        // Turns of arms of half a metre, rounded some eight times.
        ASSERT_LT((vec3(found[i]).cast<double>() - wanted[i]).norm(), 2.5e-7) << "particle " << i;
        shared += fixture.world.particles[i].bodyCount > 1;
    }
    EXPECT_EQ(fixture.stages.parameters.sharedCount, shared);
    EXPECT_EQ(shared, 1u + 3u + 4u + 5u + 1u + 3u);
}

TEST_F(Goals, StabilizationStartsParticlesFromTheMean)
{
    const auto before = fixture.stages.particles.positions.download();
    fixture.forParticles("paper/shape_goals", {{"STABILIZE", "1"}});
    fixture.run("paper/joint_goals", fixture.stages.parameters.sharedCount, {{"STABILIZE", "1"}});
    const auto found = fixture.stages.particles.positions.download();
    const auto wanted = wantedMoves();
    for (size_t i = 0; i < found.size(); ++i)
        // As above, added to places of half a metre: 3e-8 more.
        ASSERT_LT((vec3(found[i]).cast<double>() - vec3(before[i]).cast<double>() - wanted[i]).norm(), 3e-7) << i;
}

TEST_F(Goals, SharedParticlesStandBeyondTheMeanByTheirGain)
{
    for (const float bound : {1e9f, 0.05f}) {
        fixture.stages.parameters.jointCorrection = bound;
        fixture.setParameters();
        fixture.forParticles("paper/shape_goals");
        fixture.run("paper/joint_goals", fixture.stages.parameters.sharedCount);
        const auto pulls = fixture.stages.paper->linkPulls.download();
        const auto gains = fixture.stages.paper->linkGains.download();
        const auto links = fixture.stages.bodies.links.download();
        const auto positions = fixture.stages.particles.positions.download();
        const auto wanted = wantedMoves();
        uint32_t shared = 0, bounded = 0;
        for (size_t l = 0; l < fixture.world.links.size(); ++l) {
            const uint32_t i = links[l].particleIndex, b = links[l].rbIndex;
            if (fixture.world.particles[i].bodyCount < 2) {
                EXPECT_EQ(gains[l], 0.0f);
                continue;
            }
            const Vector3d r(links[l].posInRigidBodyX, links[l].posInRigidBodyY, links[l].posInRigidBodyZ);
            const Vector3d goal = vec3(starts[2 * b]).cast<double>() + vec3(moves[b]).cast<double>() +
                                  quaternion(turns[b]).cast<double>() *
                                      (quaternion(starts[2 * b + 1]).cast<double>() * r);
            Vector3d gap = vec3(positions[i]).cast<double>() + wanted[i] - goal;
            bounded += gap.norm() > bound;
            gap *= std::min(1.0, bound / gap.norm());
            // Places of half a metre, rounded some twenty times, times the gain.
            EXPECT_LT((vec3(pulls[l]).cast<double>() - gains[l] * gap).norm(), 1e-6 * (1.0 + std::abs(gains[l]))) << l;
            ++shared;
        }
        EXPECT_GT(shared, 30u);
        EXPECT_EQ(bounded > 0, bound < 1.0f);
    }
}

TEST_F(Goals, BodiesThatShareAParticleAreDrawnWithOneMass)
{
    const auto gains = fixture.stages.paper->linkGains.download();
    const auto links = fixture.stages.bodies.links.download();
    std::vector<float> mass(fixture.world.particles.size(), 0.0f);
    for (size_t l = 0; l < fixture.world.links.size(); ++l) {
        const uint32_t i = links[l].particleIndex;
        const Particle& p = fixture.world.particles[i];
        if (p.bodyCount < 2 || isFixed(fixture.world, p)) continue;
        const float drawn = (1.0f + gains[l]) * links[l].mass;
        EXPECT_GT(drawn, 0.0f);
        if (mass[i] > 0.0f) {
            EXPECT_NEAR(drawn / mass[i], 1.0f, 1e-5f) << "particle " << i;
        }
        mass[i] = drawn;
    }
}

TEST(LinkArray, IsThePapersListing1WithSharedParticlesLastInEachBlock)
{
    KernelFixture fixture(mixedWorld(byThePaper()));
    const World& world = fixture.world;
    const auto links = fixture.stages.bodies.links.download();
    const auto infos = fixture.stages.bodies.bodyInfo.download();
    ASSERT_EQ(links.size(), world.links.size());
    for (uint32_t b = 0; b < world.bodies.size(); ++b) {
        const Body& body = world.bodies[b];
        EXPECT_EQ(infos[b].linkStart, body.linkStart);
        EXPECT_EQ(infos[b].linkCount, body.linkCount);
        EXPECT_EQ(infos[b].ownCount + infos[b].jointCount, body.linkCount);
        std::vector<uint32_t> fromWorld, fromGpu;
        for (uint32_t l = body.linkStart; l < body.linkStart + body.linkCount; ++l) {
            EXPECT_EQ(links[l].rbIndex, b);
            EXPECT_EQ(links[l].particleLinksBlockStart, body.linkStart);
            EXPECT_EQ(links[l].particleLinksBlockCount, body.linkCount);
            const bool shared = world.particles[links[l].particleIndex].bodyCount > 1;
            EXPECT_EQ(shared, l - body.linkStart >= infos[b].ownCount) << "link " << l;
            fromWorld.push_back(world.links[l].particle);
            fromGpu.push_back(links[l].particleIndex);
        }
        std::sort(fromWorld.begin(), fromWorld.end());
        std::sort(fromGpu.begin(), fromGpu.end());
        EXPECT_EQ(fromGpu, fromWorld) << "body " << b;
    }
}

TEST(LinkArray, ItsInverseNamesEachParticlesLinks)
{
    KernelFixture fixture(mixedWorld(byThePaper()));
    const auto links = fixture.stages.bodies.links.download();
    const auto ranges = fixture.stages.bodies.particleLinks.download();
    const auto inverse = fixture.stages.bodies.linksOfParticle.download();
    uint32_t total = 0;
    for (uint32_t i = 0; i < ranges.size(); ++i) {
        EXPECT_EQ(ranges[i].y, fixture.world.particles[i].bodyCount);
        for (uint32_t k = ranges[i].x; k < ranges[i].x + ranges[i].y; ++k) {
            EXPECT_EQ(links[inverse[k].x].particleIndex, i);
            EXPECT_EQ(links[inverse[k].x].rbIndex, inverse[k].y);
        }
        total += ranges[i].y;
    }
    EXPECT_EQ(total, links.size());
}

}  // namespace

}  // namespace knuckle::test
