#include "tests/solver/emitter/emitter_fixture.h"

#include <numeric>

namespace knuckle::test {

namespace {

constexpr float HALF = 0.4f;

Collider regionAt(ColliderShape shape, const Vector3f& place, Random& random)
{
    Collider c;
    c.shape = shape;
    c.position = place;
    c.orientation = random.rotation();
    c.halfExtents = {0.3f, 0.15f, 0.2f};
    c.radius = 0.25f;
    return c;
}

World emitterWorld()
{
    Random random(401);
    WorldBuilder builder(DIAMETER / 2);
    Material water;
    water.fluid = true;
    builder.addMaterial({});
    const uint32_t fluid = builder.addMaterial(water);
    for (const Eigen::Vector3i& counts : {Eigen::Vector3i(4, 3, 3), {5, 1, 4}}) {
        builder.beginObject("body");
        builder.addBody("body", boxLattice(counts, DIAMETER), 0);
        builder.endObject();
    }
    for (int k = 0; k < 13; ++k) builder.addLooseParticle({});
    builder.addCollider(planeAt({0, -9, 0}, {0, 1, 0}));
    builder.addCollider(regionAt(ColliderShape::Sphere, {9, 0, 0}, random));
    for (uint32_t k = 0; k < 137; ++k) {
        const Vector3f place(5.0f + 0.1f * static_cast<float>(k), 0, 0);
        builder.addFluid(std::span(&place, 1), {0, 0, 0}, fluid);
    }
    const float d = builder.fluidSpacing();
    for (int k = 0; k < 3; ++k) {
        Emitter e;
        e.material = fluid;
        e.pool = k == 0 ? 301 : k == 1 ? 65 : 131;
        // 0.8, 1.5 and 4.5 layers a step.
        e.velocity = (k == 0 ? 2.4f : k == 1 ? 4.6f : 13.5f) * random.direction();
        e.start = k == 1 ? 0.0 : 0.107;
        if (k == 2) e.stop = 2.3;
        e.takesOldest = k == 1;
        const float side = k == 2 ? 2 * d : 6 * d;
        const Nozzle nozzle = rectangleNozzle(side, k == 0 ? 3 * d : side, d);
        e.nozzle = placed(nozzle, random.inCube(0.3f), e.velocity.normalized());
        builder.addEmitter(e);
    }
    builder.addDrain(regionAt(ColliderShape::Sphere, {0.2f, 0, 0}, random));
    builder.addDrain(regionAt(ColliderShape::Box, {-0.3f, 0.1f, 0.1f}, random));
    return builder.build();
}

}  // namespace

EmitterFixture::EmitterFixture() : KernelFixture(emitterWorld())
{
    emitters_ = stage().emitters.download();
    order = stage().poolOrder.download();
    inactive = stage().poolInactive.download();
    positions = randomVectors(world.particles.size(), HALF, 402);
    velocities = randomVectors(world.particles.size(), 1, 403);
    fill(stages.particles.positions, positions);
    fill(stages.particles.velocities, velocities);
    setSteps(7);
}

void EmitterFixture::runPools(const std::string& name, uint64_t threads, const Defines& more)
{
    Defines defines = more;
    defines.push_back({"POOL", "1"});
    run(name, threads, defines);
}

void EmitterFixture::setSteps(uint32_t steps)
{
    steps_ = steps;
    gpu::Counters now = counters();
    now.substep = steps * stages.parameters.substeps;
    setCounters(now);
}

void EmitterFixture::shuffle(uint32_t seed)
{
    Random random(seed);
    for (uint32_t k = 0; k < 2 * emitterCount(); ++k) {
        const uint32_t pool = emitter(k / 2).pool, start = poolStart(k / 2) + k % 2 * poolCapacity();
        for (uint32_t j = pool - 1; j > 0; --j) {
            const auto other = static_cast<uint32_t>(random.between(0, static_cast<float>(j) + 0.99f));
            std::swap(order[start + j], order[start + other]);
        }
    }
    fill(stage().poolOrder, order);
}

void EmitterFixture::deactivate(float share, uint32_t seed)
{
    Random random(seed);
    for (uint32_t k = 0; k < emitterCount(); ++k) {
        for (uint32_t j = 0; j < emitter(k).pool; ++j) {
            const uint32_t place = poolStart(k) + j;
            inactive[place] = random.between(0, 1) < share;
            positions[order[before() + place]].w = static_cast<float>(inactive[place]);
        }
    }
    fill(stage().poolInactive, inactive);
    fill(stages.particles.positions, positions);
    run("common/grid/scan_sum", poolCapacity() / SCAN_CHUNK, {{"POOLS", "1"}});
}

uint32_t EmitterFixture::inactiveOf(uint32_t k) const
{
    const auto first = inactive.begin() + poolStart(k);
    return std::accumulate(first, first + emitter(k).pool, 0u);
}

void EmitterFixture::setTotals(uint32_t came, uint32_t left)
{
    fill(stage().fluidTotals, std::vector<uint32_t>{came, left});
}

}  // namespace knuckle::test
