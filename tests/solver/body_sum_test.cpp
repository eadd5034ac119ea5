#include <algorithm>
#include <bit>

#include "sim/solver/solver.h"
#include "solver_test.h"

namespace knuckle::test {

namespace {

/// What a reduction leaves in the buffers of a body, in double precision, and how far single precision may be off.
struct BodySums {
    Vector3d move = Vector3d::Zero();
    Matrix3d a = Matrix3d::Zero();
    double contacts = 0.0;
    double moveTolerance = 0.0, matrixTolerance = 0.0;
};

/// Random moves, joint displacements and gaps on top of random places: nothing that a step would have made.
/// The parameter: whether A is taken FROM_POSITIONS (shaders/shared/body_shape.glsl).
class BodySum : public testing::TestWithParam<bool> {
protected:
    BodySum() : bench(mixedWorld()), shape(GetParam() ? Defines{{"FROM_POSITIONS", "1"}} : Defines{})
    {
        SolverBuffers& b = bench.buffers;
        Random random(21);
        auto moved = randomVectors(b.moved.size(), 0.02f, 22);
        for (gpu::vec4& v : moved) v.w = std::floor(random.between(0, 4));   // acting contacts
        fill(b.moved, moved);
        fill(b.linkOffsets, randomVectors(b.linkOffsets.size(), 0.01f, 23));
        fill(b.linkGaps, randomVectors(b.linkGaps.size(), 0.005f, 24));
        fill(b.bodyMoves, randomVectors(b.bodyMoves.size(), 0.02f, 25));
        fill(b.positions, randomVectors(b.positions.size(), 0.3f, 26));
        std::vector<gpu::vec4> starts;
        for (size_t k = 0; k < bench.world.bodies.size(); ++k) {
            starts.push_back(packed(random.inCube(0.4f)));
            starts.push_back(packed(random.rotation()));
        }
        fill(b.bodyStarts, starts);
        auto states = b.assemblyState.download();
        for (uint32_t k = 0; k < states.size(); ++k) states[k].y = 1 + k % 2;
        fill(b.assemblyState, states);
        for (uint32_t k = 0; k < bench.world.bodies.size(); ++k) expected.push_back(reference(k));
    }

    /// Eq. 9 with the particle's own move and, where it is shared, the joint's displacement in this body and its gap.
    BodySums reference(uint32_t body)
    {
        SolverBuffers& b = bench.buffers;
        const auto links = b.links.download();
        const auto moved = b.moved.download(), offsets = b.linkOffsets.download(), gaps = b.linkGaps.download();
        const auto starts = b.bodyStarts.download(), positions = b.positions.download();
        const double factor = b.assemblyState.download()[bench.world.bodies[body].assembly].y == 2 ? 4.0 / 9.0 : 1.0;
        const Quaternionf start = quaternion(starts[2 * body + 1]);
        const Vector3d last = vec3(b.bodyMoves.download()[body]).cast<double>();
        BodySums sums;
        double mass = 0.0, size = 0.0, armSize = 0.0;
        Vector3d weighted = Vector3d::Zero();
        uint32_t count = 0;
        for (size_t l = 0; l < links.size(); ++l) {
            const gpu::ParticleRigidBodyLink& link = links[l];
            if (link.rbIndex != body) continue;
            const uint32_t i = link.particleIndex;
            const bool shared = bench.world.particles[i].bodyCount > 1;
            const Vector3d r(link.posInRigidBodyX, link.posInRigidBodyY, link.posInRigidBodyZ);
            Vector3d move = vec3(moved[i]).cast<double>();
            if (shared) move += factor * vec3(offsets[l]).cast<double>();
            Vector3d arm = start.cast<double>() * r + move;
            if (shared) arm += vec3(gaps[l]).cast<double>();
            if (!shape.empty()) arm = (vec3(positions[i]) - vec3(starts[2 * body])).cast<double>() + move;
            weighted += link.mass * move;
            mass += link.mass;
            sums.a += link.mass * arm * r.transpose();
            sums.contacts += moved[i].w;
            size += link.mass * (move - last).norm();
            armSize += link.mass * (arm.norm() + 0.5) * r.norm();
            ++count;
        }
        sums.move = weighted / mass;
        // Each of n additions and some eight operations a term round by 2^-24 of at most the sum of the sizes; places
        // up to half a metre enter the arms.
        const double rounding = (count + 8) * 0x1p-24;
        sums.moveTolerance = rounding * (size / mass + last.norm());
        sums.matrixTolerance = rounding * armSize;
        return sums;
    }
    void expectSums()
    {
        gpu().checkErrors();
        const auto moves = bench.buffers.bodyMoves.download();
        const auto matrices = bench.buffers.bodyMatrices.download();
        for (uint32_t b = 0; b < expected.size(); ++b) {
            SCOPED_TRACE("body " + std::to_string(b));
            EXPECT_LT((vec3(moves[b]).cast<double>() - expected[b].move).norm(), expected[b].moveTolerance);
            EXPECT_EQ(moves[b].w, expected[b].contacts);
            Matrix3d a;
            for (uint32_t c = 0; c < 3; ++c) a.col(c) = vec3(matrices[3 * b + c]).cast<double>();
            EXPECT_LE((a - expected[b].a).norm(), expected[b].matrixTolerance);
        }
    }
    void reduce(const Kernel& terms, const Kernel& collect)
    {
        const Kernel step = bench.load("link_reduce");
        const uint32_t links = groupsFor(bench.buffers.parameters.linkCount);
        bench.dispatch(terms, links);
        for (uint32_t stride = 1; stride < bench.buffers.longestBody; stride *= 2) {
            glProgramUniform1ui(step.program(), 0, stride);
            bench.dispatch(step, links);
        }
        bench.dispatch(collect, groupsFor(bench.buffers.parameters.bodyCount));
    }
    void reduceInSteps()
    {
        Defines centres = shape;
        centres.push_back({"CENTRES", "1"});
        reduce(bench.load("link_terms", centres), bench.load("body_collect", {{"CENTRES", "1"}}));
        reduce(bench.load("link_terms", shape), bench.load("body_collect"));
    }

    Bench bench;
    Defines shape;
    std::vector<BodySums> expected;   ///< Of what the buffers held at first: the kernels overwrite bodyMoves.
};

/// As the paper's solver runs them, which moves particles off their goals.
TEST_P(BodySum, OneThreadABodySumsItsLinks)
{
    bench.forBodies("body_sum", shape);
    expectSums();
}

TEST_P(BodySum, OneGroupABodySumsItsLinks)
{
    bench.dispatch(bench.load("body_sum_group", shape), bench.buffers.parameters.bodyCount);
    expectSums();
}

TEST_P(BodySum, ThePapersStepsSumTheLinksOfEachBody)
{
    reduceInSteps();
    expectSums();
}

TEST_P(BodySum, SomeBodiesAreLongerThanAGroupAndNoPowerOfTwo)
{
    EXPECT_EQ(bench.buffers.longestBody, 81u);
    EXPECT_GT(bench.buffers.longestBody, 2u * BODY_GROUP_SIZE);
    EXPECT_FALSE(std::has_single_bit(bench.buffers.longestBody));
}

INSTANTIATE_TEST_SUITE_P(Shape, BodySum, testing::Bool(), [](const auto& about) {
    return about.param ? "FromPositions" : "FromRest";
});

TEST(PaperReduction, TakesAsManyStepsAsEquation10)
{
    Settings settings = paperSettings();
    settings.iterations = 1;
    settings.stabilization = 0;
    const World world = mixedWorld(settings);
    Solver solver(gpu(), world);
    solver.setTiming(true);
    solver.step();
    uint64_t terms = 0, steps = 0;
    for (const PassTime& pass : solver.passTimes()) {
        if (pass.name == "link_terms") terms = pass.count;
        if (pass.name == "link_reduce") steps = pass.count;
    }
    // ceil(log2 81) + 1 = 8, once for the centres and once for A, the first of each being link_terms.
    EXPECT_EQ(terms, 2u);
    EXPECT_EQ(steps, 2u * 7u);
}

}  // namespace

}  // namespace knuckle::test
