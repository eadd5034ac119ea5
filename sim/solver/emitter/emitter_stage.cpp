#include "sim/solver/emitter/emitter_stage.h"

#include <algorithm>
#include <cmath>

#include "sim/solver/pack.h"
#include "sim/solver/scan.h"

namespace knuckle {

namespace {

/// Fluid nearer than this share of the pitch blocks a particle that leaves a nozzle. A nozzle inside fluid at rest
/// emits 98 % of its flow with 0.25, 84 % with 0.4, nothing with 0.5.
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

gpu::Emitter packEmitter(const Emitter& e, const World& world)
{
    const double step = world.settings.timeStep, rate = 1.0 / e.interval();
    // Emitters work at the end of a step, so nothing leaves before the end of the first.
    const double first = std::max(1.0, std::ceil(e.start / step));
    const Fixed past((first * step - e.start) * rate), perStep(step * rate);
    gpu::Emitter out{};
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

EmitterStage::EmitterStage(const StageSetup& setup)
    : parameters_(setup.parameters), hasEmitters_(!setup.world.emitters.empty()),
      emit_(*this, "emitter/fluid_emit", definesOf({{"FLUIDS", true}, {"AGES", setup.world.shown.ages}}), hasEmitters_)
{
}

void EmitterStage::upload(const StageSetup& setup)
{
    gpu::StepParameters& p = setup.parameters;
    p.drainCount = static_cast<uint32_t>(setup.world.drains.size());
    uploadPools(setup);
}

void EmitterStage::uploadPools(const StageSetup& setup)
{
    gpu::StepParameters& p = setup.parameters;
    std::vector<gpu::Emitter> all;
    std::vector<gpu::vec4> points;
    std::vector<uint32_t> order, inactive, chunks;
    uint32_t particle = p.particleCount + p.fluidFilled;
    for (const Emitter& e : setup.world.emitters) {
        gpu::Emitter emitter = packEmitter(e, setup.world);
        emitter.firstPoint = static_cast<uint32_t>(points.size());
        emitter.poolStart = static_cast<uint32_t>(order.size());
        for (const Vector3f& point : e.nozzle.points) points.push_back(pack(point, 0));
        for (uint32_t k = 0; k < e.pool; ++k) order.push_back(particle++);
        inactive.resize(order.size(), 1);
        order.resize(wholeChunks(static_cast<uint32_t>(order.size())), NO_INDEX);
        chunks.resize(order.size() / SCAN_CHUNK, static_cast<uint32_t>(all.size()));
        all.push_back(emitter);
        // One more chunk at the end: its prefix sum is the total.
        p.poolCapacity = static_cast<uint32_t>(order.size() + SCAN_CHUNK);
        inactive.resize(order.size(), 0);
    }
    order.resize(p.poolCapacity, NO_INDEX);
    inactive.resize(p.poolCapacity, 0);
    order.insert(order.end(), order.begin(), order.end());  // two halves
    emitters = {"emitters", std::span<const gpu::Emitter>(all)};
    emitterStates = {"emitterStates", all.size()};
    nozzlePoints = {"nozzlePoints", std::span<const gpu::vec4>(points)};
    poolOrder = {"poolOrder", std::span<const uint32_t>(order)};
    poolInactive = {"poolInactive", std::span<const uint32_t>(inactive)};
    poolSums = scanSums("poolSums", p.poolCapacity);
    poolChunks = {"poolChunks", std::span<const uint32_t>(chunks)};
    fluidTotals = {"fluidTotals", 2};
}

void EmitterStage::addBuffers(BufferTable& table)
{
    table.add(Lifetime::Constant, emitters, nozzlePoints, poolChunks);
    table.add(Lifetime::State, emitterStates, poolOrder, poolInactive, poolSums);
    ElementType bothAtOnce = elementType<uint32_t>();
    bothAtOnce.texelBytes = 8;
    table.add("fluidTotals", fluidTotals, bothAtOnce, Lifetime::State);
}

void EmitterStage::endStep(Recorder& recorder) const
{
    const uint32_t chunks = parameters_.poolCapacity / SCAN_CHUNK;
    if (hasEmitters_) recorder.perElement(sum_, chunks);
    recorder.groups(update_, 1);
    if (hasEmitters_) {
        recorder.perElement(order_, chunks);
        recorder.decided(emit_, DISPATCH_EMIT);
    }
    recorder.perElement(drain_, parameters_.fluidFilled + parameters_.poolCapacity);
}

void EmitterStage::measure(Measures& out) const
{
    const std::vector<uint32_t> totals = fluidTotals.download();
    out.fluidEmitted = totals[0];
    out.fluidDrained = totals[1];
    out.fluidCount = parameters_.fluidFilled + totals[0] - totals[1];
}

}  // namespace knuckle
