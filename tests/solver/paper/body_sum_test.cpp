#include <bit>

#include "sim/solver/solver.h"
#include "tests/solver/solver_test.h"

namespace knuckle::test {

namespace {

/// Results of a reduction in the stages of a body, in double precision, and the tolerance for single precision.
struct BodySums {
    Vector3d move = Vector3d::Zero();
    Matrix3d a = Matrix3d::Zero();
    double moveTolerance = 0.0, matrixTolerance = 0.0;
};

/// Random moves on top of random places, off the goals of the paper's solver.
class BodySum : public testing::Test {
protected:
    BodySum() : fixture(mixedWorld(byThePaper()))
    {
        Stages& b = fixture.stages;
        Random random(21);
        fill(b.paper->moved, randomVectors(b.paper->moved.size(), 0.02f, 22));
        fill(b.bodies.moverMoves, randomVectors(b.bodies.moverMoves.size(), 0.02f, 25));
        fill(b.particles.positions, randomVectors(b.particles.positions.size(), 0.3f, 26));
        fill(b.paper->linkPulls, randomVectors(b.paper->linkPulls.size(), 0.1f, 27));
        std::vector<gpu::vec4> starts;
        for (size_t k = 0; k < fixture.world.bodies.size(); ++k) {
            starts.push_back(packed(random.inCube(0.4f)));
            starts.push_back(packed(random.rotation()));
        }
        fill(b.paper->bodyStarts, starts);
        for (uint32_t k = 0; k < fixture.world.bodies.size(); ++k) expected.push_back(reference(k));
    }

    /// Eq. 9 about the centre before the substep, and the mean of the particles' moves. Shared particles are pulled,
    /// and move from where the body had them.
    BodySums reference(uint32_t body)
    {
        Stages& b = fixture.stages;
        const auto links = b.bodies.links.download();
        const auto pulls = b.paper->linkPulls.download();
        const auto moved = b.paper->moved.download(), starts = b.paper->bodyStarts.download(),
                   positions = b.particles.positions.download();
        const Vector3d centre = vec3(starts[2 * body]).cast<double>();
        const Vector3d last = vec3(b.bodies.moverMoves.download()[body]).cast<double>();
        BodySums sums;
        double mass = 0.0, size = 0.0, armSize = 0.0;
        Vector3d weighted = Vector3d::Zero();
        uint32_t count = 0;
        for (size_t l = 0; l < links.size(); ++l) {
            const gpu::ParticleRigidBodyLink& link = links[l];
            if (link.rbIndex != body) continue;
            const uint32_t i = link.particleIndex;
            const Vector3d r(link.posInRigidBodyX, link.posInRigidBodyY, link.posInRigidBodyZ);
            const bool shared = fixture.world.particles[i].bodyCount > 1;
            const Vector3d place = vec3(positions[i]).cast<double>();
            Vector3d move = vec3(moved[i]).cast<double>();
            if (shared) move += vec3(pulls[l]).cast<double>();
            const Vector3d arm = place - centre + move;
            if (shared) move = arm - quaternion(starts[2 * body + 1]).cast<double>() * r;
            weighted += link.mass * move;
            mass += link.mass;
            sums.a += link.mass * arm * r.transpose();
            size += link.mass * ((move - last).norm() + (shared ? place.norm() + centre.norm() + r.norm() : 0.0));
            armSize += link.mass * (place.norm() + centre.norm() + arm.norm()) * r.norm();
            ++count;
        }
        sums.move = weighted / mass;
        // Each of n additions and some eight operations a term round by 2^-24 of at most the sum of the sizes.
        const double rounding = (count + 8) * 0x1p-24;
        sums.moveTolerance = rounding * (size / mass + last.norm());
        sums.matrixTolerance = rounding * armSize;
        return sums;
    }
    void expectSums()
    {
        gpu().checkErrors();
        const auto moves = fixture.stages.bodies.moverMoves.download();
        const auto matrices = fixture.stages.paper->bodyMatrices.download();
        for (uint32_t b = 0; b < expected.size(); ++b) {
            SCOPED_TRACE("body " + std::to_string(b));
            EXPECT_LT((vec3(moves[b]).cast<double>() - expected[b].move).norm(), expected[b].moveTolerance);
            Matrix3d a;
            for (uint32_t c = 0; c < 3; ++c) a.col(c) = vec3(matrices[3 * b + c]).cast<double>();
            EXPECT_LE((a - expected[b].a).norm(), expected[b].matrixTolerance);
        }
    }
    void reduce(const Defines& defines)
    {
        const Kernel terms = fixture.load("paper/link_terms", defines),
                     step = fixture.load("paper/link_reduce", defines),
                     collect = fixture.load("paper/body_collect", defines);
        const uint32_t links = groupsFor(fixture.stages.parameters.linkCount);
        fixture.dispatch(terms, links);
        for (const PaperStage::ReductionStep& s : fixture.stages.paper->reductionSteps) {
            glProgramUniform3ui(step.program(), 0, s.begin, s.end, s.stride);
            fixture.dispatch(step, groupsFor(s.end - s.begin));
        }
        fixture.dispatch(collect, groupsFor(fixture.stages.parameters.bodyCount));
    }
    void reduceInSteps()
    {
        reduce({{"CENTRES", "1"}});
        reduce({});
    }

    KernelFixture fixture;
    std::vector<BodySums> expected;  ///< Of what the stages held at first: the kernels overwrite moverMoves.
};

TEST_F(BodySum, OneThreadABodySumsItsLinks)
{
    fixture.forBodies("paper/body_sum");
    expectSums();
}

TEST_F(BodySum, OneGroupABodySumsItsLinks)
{
    fixture.dispatch(fixture.load("paper/body_sum_group"), fixture.stages.parameters.bodyCount);
    expectSums();
}

TEST_F(BodySum, ThePapersStepsSumTheLinksOfEachBody)
{
    reduceInSteps();
    expectSums();
}

TEST_F(BodySum, SomeBodiesAreLongerThanAGroupAndNoPowerOfTwo)
{
    uint32_t longest = 0;
    for (const Body& body : fixture.world.bodies) longest = std::max(longest, body.linkCount);
    EXPECT_EQ(longest, 81u);
    EXPECT_GT(longest, 2u * BODY_GROUP_SIZE);
    EXPECT_FALSE(std::has_single_bit(longest));
}

TEST(PaperReduction, TakesAsManyStepsAsEquation10)
{
    Settings settings = paperSettings();
    settings.substeps = settings.iterations = 1;
    settings.stabilization = 0;
    const World world = mixedWorld(settings);
    Solver solver(gpu(), world);
    solver.timePasses();
    solver.step();
    uint64_t terms = 0, steps = 0;
    for (const PassTime& pass : solver.passTimes()) {
        if (pass.name.starts_with("link_terms")) terms += pass.count;
        if (pass.name.starts_with("link_reduce")) steps += pass.count;
    }
    // ceil(log2 81) + 1 = 8, once for the centres and once for A, the first of each being link_terms.
    EXPECT_EQ(terms, 2u);
    EXPECT_EQ(steps, 2u * 7u);
}

}  // namespace

}  // namespace knuckle::test
