#include "sim/solver/fluid/upload_pool.h"

#include <algorithm>
#include <cmath>

#include "sim/solver/pack.h"

namespace knuckle {

namespace {

/// Fluid nearer than this share of the pitch is in the way of what leaves a nozzle. Into fluid at rest, one lets out
/// 98 % of its flow with 0.25, 84 % with 0.4, nothing with 0.5.
constexpr float ROOM = 0.25f;

uint32_t wholeChunks(uint32_t count)
{
    return (count + SCAN_CHUNK - 1) / SCAN_CHUNK * SCAN_CHUNK;
}

/// A number of layers as 64 bits of 2^-32.
struct Fixed {
    explicit Fixed(double layers) : bits(static_cast<uint64_t>(std::llround(std::ldexp(layers, 32)))) {}
    uint32_t low() const { return static_cast<uint32_t>(bits); }
    uint32_t high() const { return static_cast<uint32_t>(bits >> 32); }
    uint64_t bits;
};

gpu::GpuEmitter packEmitter(const Emitter& e, const World& world)
{
    const double step = world.settings.timeStep, rate = 1.0 / e.interval();
    // Emitters end a step: nothing leaves before the first.
    const double first = std::max(1.0, std::ceil(e.start / step));
    const Fixed past((first * step - e.start) * rate), perStep(step * rate);
    gpu::GpuEmitter out{};
    out.velocity = pack(e.velocity, ROOM * std::min({e.nozzle.pitch, e.nozzle.layerSpacing, world.fluidSpacing}));
    out.clock = {past.low(), past.high(), perStep.low(), perStep.high()};
    out.startStep = static_cast<uint32_t>(first);
    out.layerLimit = static_cast<uint32_t>(std::min<uint64_t>(e.layersUntil(e.stop), 0xffffffffu));
    out.pointCount = static_cast<uint32_t>(e.nozzle.points.size());
    out.poolCount = e.pool;
    out.takesOldest = e.takesOldest ? 1u : 0u;
    out.interval = static_cast<float>(e.interval());
    return out;
}

}  // namespace

void makePool(SolverBuffers& out, const World& world)
{
    gpu::StepParameters& p = out.parameters;
    p.substeps = world.settings.substeps;
    p.fluidFilled = world.fluidCount - world.pooledCount();
    p.drainCount = static_cast<uint32_t>(world.drains.size());
    out.hasPool = world.fluidCount > 0 && !(world.emitters.empty() && world.drains.empty());
    std::vector<gpu::GpuEmitter> emitters;
    std::vector<gpu::vec4> points;
    std::vector<uint32_t> order, parked, chunks;
    uint32_t particle = p.particleCount + p.fluidFilled;
    for (const Emitter& e : world.emitters) {
        gpu::GpuEmitter emitter = packEmitter(e, world);
        emitter.firstPoint = static_cast<uint32_t>(points.size());
        emitter.poolStart = static_cast<uint32_t>(order.size());
        for (const Vector3f& point : e.nozzle.points) points.push_back(pack(point, 0));
        for (uint32_t k = 0; k < e.pool; ++k) order.push_back(particle++);
        parked.resize(order.size(), 1);
        order.resize(wholeChunks(static_cast<uint32_t>(order.size())), NO_INDEX);
        chunks.resize(order.size() / SCAN_CHUNK, static_cast<uint32_t>(emitters.size()));
        emitters.push_back(emitter);
        // One more chunk at the end: the prefix sum of it is that of all.
        p.poolCapacity = static_cast<uint32_t>(order.size() + SCAN_CHUNK);
        parked.resize(order.size(), 0);
    }
    order.resize(p.poolCapacity, NO_INDEX);
    parked.resize(p.poolCapacity, 0);
    order.insert(order.end(), order.begin(), order.end());   // two halves
    PoolBuffers& b = out.pool;
    b.emitters = {"emitters", std::span<const gpu::GpuEmitter>(emitters)};
    b.emitterStates = {"emitterStates", emitters.size()};
    b.nozzlePoints = {"nozzlePoints", std::span<const gpu::vec4>(points)};
    b.poolOrder = {"poolOrder", std::span<const uint32_t>(order)};
    b.poolInactive = {"poolInactive", std::span<const uint32_t>(parked)};
    b.poolSums = {"poolSums", p.poolCapacity / SCAN_CHUNK};
    b.poolChunks = {"poolChunks", std::span<const uint32_t>(chunks)};
    b.fluidTotals = {"fluidTotals", 1};
    std::vector<gpu::uvec4> dispatches(DISPATCH_COUNT);
    dispatches[DISPATCH_SLOTS] = {(p.particleCount + p.fluidFilled + GROUP_SIZE - 1) / GROUP_SIZE, 1, 1, 0};
    out.dispatches = {"dispatches", std::span<const gpu::uvec4>(dispatches)};
}

void addPool(BufferTable& table, PoolBuffers& b)
{
    table.add(b.emitters, b.emitterStates, b.nozzlePoints, b.poolOrder, b.poolInactive, b.poolSums, b.poolChunks,
              b.fluidTotals);
}

FluidFigures fluidFigures(const SolverBuffers& buffers)
{
    const gpu::uvec2 totals = buffers.pool.fluidTotals.download()[0];
    return {totals.x, totals.y, buffers.parameters.fluidFilled + totals.x - totals.y};
}

}  // namespace knuckle
