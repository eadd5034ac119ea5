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
    ASSERT_GT(all.buffers.parameters.moverCount, all.buffers.parameters.bodyCount);
    const auto impulses = randomVectors(all.buffers.moverImpulses.size(), 0.001f, 3);
    for (KernelFixture* fixture : {&all, &apart}) fill(fixture->buffers.moverImpulses, impulses);
    for (const char* kernel : {"body/mover_predict", "body/mover_solve", "body/mover_integrate"}) {
        all.forMovers(kernel);
        apart.forMovers(kernel, {{"BODIES", "1"}});
        apart.forMovers(kernel, {{"LOOSE", "1"}});
        SCOPED_TRACE(kernel);
        expectSameBits(all.buffers.moverPredictions, apart.buffers.moverPredictions);
        expectSameBits(all.buffers.moverMoves, apart.buffers.moverMoves);
        expectSameBits(all.buffers.moverRotationDeltas, apart.buffers.moverRotationDeltas);
        expectSameBits(all.buffers.moverCentres, apart.buffers.moverCentres);
        expectSameBits(all.buffers.moverVelocities, apart.buffers.moverVelocities);
    }
}

}  // namespace knuckle::test
