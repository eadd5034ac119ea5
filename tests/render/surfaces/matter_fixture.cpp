#include "tests/render/surfaces/matter_fixture.h"

#include "sim/solver/strand/strand_order.h"

namespace knuckle::test {

void expectColorsBySpeed(World world, float distance)
{
    RenderSettings settings = redView({0, 0, distance});
    settings.colorBy = ColorBy::Speed;
    settings.speedScale = 5.0f;
    const auto middle = [&] { return pixelAt(drawn(world, settings), PICTURE / 2, PICTURE / 2); };
    const Eigen::Vector3i slow = middle();
    for (Particle& particle : world.particles) particle.velocity = Vector3f(0, 5, 0);
    const Eigen::Vector3i fast = middle();
    EXPECT_GT(slow.z(), slow.x() + 20);
    EXPECT_GT(fast.x(), slow.x() + 60);
}

Image drawnTorn(const World& world, const RenderSettings& settings, const std::vector<size_t>& torn)
{
    std::vector<gpu::vec4> states(strandOrder(world).nodeCount);
    for (const size_t index : torn) states.at(index).z = 1.0f;
    Gpu& gpu = sharedGpu();
    const StillBuffers buffers(world);
    const Buffer<gpu::vec4> distances("distances", std::span<const gpu::vec4>(states));
    ParticleView view = buffers.view();
    view.distanceStates = distances.id();
    view.distanceCount = static_cast<uint32_t>(distances.size());
    Renderer renderer(gpu, world, settings);
    renderer.draw(view, 0.0);
    Image image = renderer.readImage();
    EXPECT_NO_THROW(gpu.checkErrors());
    return image;
}

}  // namespace knuckle::test
