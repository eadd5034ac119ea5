#include <bit>

#include "tests/solver/solver_test.h"

namespace knuckle::test {

namespace {

void expectSameBits(const Buffer<gpu::vec4>& one, const Buffer<gpu::vec4>& other)
{
    const auto a = one.download(), b = other.download();
    ASSERT_EQ(a.size(), b.size());
    for (size_t i = 0; i < a.size(); ++i)
        for (auto member : {&gpu::vec4::x, &gpu::vec4::y, &gpu::vec4::z, &gpu::vec4::w})
            ASSERT_EQ(std::bit_cast<uint32_t>(a[i].*member), std::bit_cast<uint32_t>(b[i].*member))
                << one.label() << " " << i;
}

}  // namespace

TEST(MoverVariants, KernelsForBodiesAndForLooseParticlesDoWhatOneForAllDoes)
{
    KernelFixture all(mixedWorld()), apart(mixedWorld());
    ASSERT_GT(all.stages.parameters.moverCount, all.stages.parameters.bodyCount);
    const auto impulses = randomVectors(all.stages.bodies.moverImpulses.size(), 0.001f, 3);
    for (KernelFixture* fixture : {&all, &apart}) fill(fixture->stages.bodies.moverImpulses, impulses);
    for (const char* kernel : {"body/mover_predict", "body/mover_solve", "body/mover_integrate"}) {
        all.forMovers(kernel);
        apart.forMovers(kernel, {{"BODIES", "1"}});
        apart.forMovers(kernel, {{"LOOSE", "1"}});
        SCOPED_TRACE(kernel);
        expectSameBits(all.stages.bodies.moverPredictions, apart.stages.bodies.moverPredictions);
        expectSameBits(all.stages.bodies.moverMoves, apart.stages.bodies.moverMoves);
        expectSameBits(all.stages.bodies.moverRotationDeltas, apart.stages.bodies.moverRotationDeltas);
        expectSameBits(all.stages.bodies.moverCentres, apart.stages.bodies.moverCentres);
        expectSameBits(all.stages.bodies.moverVelocities, apart.stages.bodies.moverVelocities);
    }
}

}  // namespace knuckle::test
