#include <algorithm>
#include <cmath>

#include "tests/solver/body/mover_fixture.h"

namespace knuckle::test {

namespace {

/// Joints whose bodies were moved and turned apart by up to some centimetres.
class JointSolve : public testing::Test {
protected:
    JointSolve()
    {
        Stages& b = fixture.stages;
        // Bodies of a joint start in place, so the distance between their goals is small beside the positions.
        for (uint32_t m = 0; m < fixture.moverCount(); ++m) {
            fixture.centres[m] = fixture.isBody(m) ? packed(fixture.world.bodies[m].position) : fixture.centres[m];
            fixture.rotations[m] = fixture.isBody(m) ? packed(fixture.world.bodies[m].rotation) : fixture.rotations[m];
        }
        fill(b.bodies.moverCentres, fixture.centres);
        fill(b.bodies.moverRotations, fixture.rotations);
        fixture.setMoves(0.01f, 0.05f, 0.0f);
        Random random(121);
        std::vector<gpu::vec4> changes(b.bodies.moverChanges.size());
        for (uint32_t m = 0; m < fixture.moverCount(); ++m) {
            relaxations.push_back(random.between(1, MOST_RELAXATION));
            splits.push_back(fixture.isFixed(m) ? 0.0f : 1 + std::floor(random.between(0, 9)));
            fixture.moves[m].w = splits[m] / relaxations[m];
            changes[fixture.fieldStart(m)].w = relaxations[m];
        }
        fill(b.bodies.moverMoves, fixture.moves);
        fill(b.bodies.moverChanges, changes);
        links = b.bodies.links.download();
        masses = b.bodies.linkMasses.download();
        old = randomVectors(links.size(), 0.1f, 122);
        linkRows = b.joints.linkRows.download();
        std::vector<gpu::vec4> rows(b.bodies.rowImpulses.size());
        for (size_t l = 0; l < links.size(); ++l)
            if (rowOf(l) != NO_INDEX) rows[rowOf(l)] = old[l];
        fill(b.bodies.rowImpulses, rows);
    }
    uint32_t rowOf(size_t link) const { return linkRows[link]; }
    struct Owner {
        size_t link;
        Vector3d goal;       ///< Where its body would have the particle [m].
        double inverseMass;  ///< There, of the body split over all its impulses [1/kg].
    };
    /// The links of a particle, as they stand in the link array.
    std::vector<Owner> ownersOf(uint32_t particle) const
    {
        std::vector<Owner> owners;
        for (size_t l = 0; l < links.size(); ++l) {
            if (links[l].particleIndex != particle) continue;
            const uint32_t m = links[l].rbIndex;
            const Vector3d r(links[l].posInRigidBodyX, links[l].posInRigidBodyY, links[l].posInRigidBodyZ);
            const Vector3d goal = fixture.centre(m) + fixture.arm(m, r) + fixture.moveOf(m, r);
            owners.push_back({l, goal, double(masses[l]) * splits[m]});
        }
        return owners;
    }
    std::vector<gpu::vec4> solve(const Defines& defines)
    {
        const gpu::StepParameters& p = fixture.stages.parameters;
        fixture.run("joint/joint_solve", p.sharedByTwo, defines);
        fixture.run("joint/joint_solve_many", p.sharedCount - p.sharedByTwo, defines);
        // Per link; those of other particles have no row.
        const auto rows = fixture.stages.bodies.rowImpulses.download();
        auto impulses = old;
        for (size_t l = 0; l < links.size(); ++l)
            if (rowOf(l) != NO_INDEX) impulses[l] = rows[rowOf(l)];
        return impulses;
    }
    /// Each body is drawn to the mean of the goals: by n (mean - goal), over the inverse masses together.
    void expectImpulses(const std::vector<gpu::vec4>& before, const std::vector<gpu::vec4>& after) const
    {
        std::vector<uint32_t> jointsOf(4);
        for (uint32_t i = 0; i < fixture.world.particles.size(); ++i) {
            const auto owners = ownersOf(i);
            Vector3d sum = Vector3d::Zero();
            double inverseMass = 0.0;
            for (const Owner& o : owners) sum += o.goal;
            for (const Owner& o : owners) inverseMass += o.inverseMass;
            const auto n = static_cast<double>(owners.size());
            for (const Owner& o : owners) {
                const double relaxation = fixture.stages.parameters.jointRelaxation;
                const Vector3d p = owners.size() > 1 ? Vector3d(relaxation * (sum - n * o.goal) / inverseMass)
                                                     : Vector3d::Zero();
                const Vector3f start = vec3(owners.size() > 1 ? before[o.link] : old[o.link]);
                const Vector3d wanted = start.cast<double>() + p;
                // Goals are differences of places up to a metre, off by some 16 roundings.
                const double rounding = 16 * EPSILON * (relaxation * n / std::max(inverseMass, 1e-3) + wanted.norm());
                ASSERT_LE((vec3(after[o.link]).cast<double>() - wanted).norm(), rounding) << "link " << o.link;
            }
            ++jointsOf[owners.size()];
        }
        EXPECT_EQ(jointsOf[2] + jointsOf[3], 17u);
        EXPECT_EQ(jointsOf[3], 1u) << "the middle of the universal joint";
    }

    MoverFixture fixture;
    std::vector<gpu::ParticleRigidBodyLink> links;
    std::vector<float> masses, relaxations, splits;  ///< Per link, mover, mover.
    std::vector<uint32_t> linkRows;
    std::vector<gpu::vec4> old;
};

TEST_F(JointSolve, TheFirstOfASubstepSetsTheImpulsesOfJoints)
{
    expectImpulses(std::vector<gpu::vec4>(old.size()), solve({{"FIRST_ITERATION", "1"}}));
}

TEST_F(JointSolve, LaterOnesAddToThem)
{
    expectImpulses(old, solve({}));
}

TEST_F(JointSolve, ImpulsesOfASharedParticleSumToZero)
{
    // Of two bodies to the last bit, also after more of them.
    solve({{"FIRST_ITERATION", "1"}});
    solve({});
    const auto found = solve({});
    uint32_t pairs = 0, triples = 0;
    for (uint32_t i = 0; i < fixture.world.particles.size(); ++i) {
        const auto owners = ownersOf(i);
        if (owners.size() < 2) continue;
        Vector3f sum = Vector3f::Zero();
        float size = 0;
        for (const Owner& o : owners) sum += vec3(found[o.link]);
        for (const Owner& o : owners) size += vec3(found[o.link]).norm();
        EXPECT_GT(size, 0.0f) << "particle " << i;
        // Of three: each has been rounded some four times in each of three solves.
        EXPECT_LE(sum.norm(), owners.size() == 2 ? 0.0 : 12 * EPSILON * size) << "particle " << i;
        ++(owners.size() == 2 ? pairs : triples);
    }
    EXPECT_EQ(pairs, 16u);
    EXPECT_EQ(triples, 1u);
}

TEST_F(JointSolve, AnImpulseMovesTheGoalsOfTwoBodiesTogether)
{
    fixture.stages.parameters.jointRelaxation = 1.0f;
    fixture.setParameters();
    const auto found = solve({{"FIRST_ITERATION", "1"}});
    uint32_t held = 0;
    for (uint32_t i = 0; i < fixture.world.particles.size(); ++i) {
        const auto owners = ownersOf(i);
        if (owners.size() != 2) continue;
        const auto moved = [&](const Owner& o) {
            return Vector3d(o.goal + o.inverseMass * vec3(found[o.link]).cast<double>());
        };
        EXPECT_GT((owners[0].goal - owners[1].goal).norm(), 1e-4) << "particle " << i;
        // Places up to a metre, rounded some eight times.
        EXPECT_LT((moved(owners[0]) - moved(owners[1])).norm(), 8 * EPSILON) << "particle " << i;
        held += owners[0].inverseMass == 0.0;
    }
    EXPECT_EQ(held, 3u) << "of the hinge to a fixed body, which stays";
}

TEST_F(JointSolve, BodiesThatCannotMoveOweEachOtherNothing)
{
    fixture.stages.bodies.linkMasses.clear();
    const auto found = solve({{"FIRST_ITERATION", "1"}});
    for (size_t l = 0; l < links.size(); ++l) {
        const bool shared = fixture.world.particles[links[l].particleIndex].bodyCount > 1;
        EXPECT_EQ(vec3(found[l]), shared ? Vector3f(0, 0, 0) : vec3(old[l])) << "link " << l;
    }
}

}  // namespace

}  // namespace knuckle::test
