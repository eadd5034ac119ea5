#include "sim/solver/forces/force_stage.h"

#include <cmath>
#include <numbers>

#include "sim/solver/pack.h"

namespace knuckle {

namespace {

static_assert(static_cast<uint32_t>(FieldKind::Blow) == FIELD_BLOW);
static_assert(static_cast<uint32_t>(FieldFalloff::Linear) == FALLOFF_LINEAR);

gpu::ForceField packField(const ForceField& field)
{
    const Region& region = field.region;
    return {pack(region.position, field.strength),
            pack(region.orientation),
            pack(sizeOf(region), reachOf(region)),
            {static_cast<uint32_t>(region.shape), static_cast<uint32_t>(field.kind),
             static_cast<uint32_t>(field.falloff), 0},
            {field.start, field.stop, 0, 0}};
}

/// Of a sphere of a fluid particle's volume.
float dropDrag(float spacing)
{
    const float radius = spacing * std::cbrt(0.75f / std::numbers::pi_v<float>);
    return 0.5f * float(SPHERE_DRAG) * std::numbers::pi_v<float> * radius * radius;
}

}  // namespace

ForceStage::ForceStage(const StageSetup& setup)
    : parameters_(setup.parameters), wind_(setup.world.wind.value_or(Wind{.density = 0.0f})),
      hasMovers_(setup.layout.moverCount() > 0), hasFluids_(setup.world.fluidCount > 0),
      hasCloth_(!setup.world.clothTriangles.empty())
{
}

void ForceStage::upload(const StageSetup& setup)
{
    const World& world = setup.world;
    setup.parameters.wind.w = wind_.density;
    adapt(setup.parameters);
    setup.parameters.dropDrag = dropDrag(world.fluidSpacing);
    std::vector<gpu::ForceField> fields;
    for (const ForceField& field : world.forceFields) fields.push_back(packField(field));
    setup.parameters.forceFieldCount = static_cast<uint32_t>(fields.size());
    std::vector<gpu::vec4> drags;
    for (const Vector3f& drag : dragsOf(world)) drags.push_back(pack(drag, 0));
    forceFields = {"forceFields", std::span<const gpu::ForceField>(fields)};
    moverDrags = {"moverDrags", std::span<const gpu::vec4>(drags)};
    moverAccelerations = {"moverAccelerations", drags.size()};
    uploadCloth(setup);
}

void ForceStage::adapt(gpu::StepParameters& p)
{
    Wind wind = wind_;
    wind.velocity = vectorOf(p.wind);
    std::vector<gpu::GustWave> waves;
    for (const GustWave& w : knuckle::gustWaves(wind))
        waves.push_back({pack(w.wave, w.phase), pack(w.amplitude, w.rate - w.wave.dot(wind.velocity))});
    p.gustWaveCount = static_cast<uint32_t>(waves.size());
    gustWaves = {"gustWaves", std::span<const gpu::GustWave>(waves)};
}

void ForceStage::uploadCloth(const StageSetup& setup)
{
    const World& world = setup.world;
    std::vector<std::vector<gpu::uvec4>> around(hasCloth_ ? world.solidCount() : 0);
    for (const auto& [a, b, c] : world.clothTriangles)
        for (const uint32_t corner : {a, b, c}) around[corner].push_back({a, b, c, 0});
    std::vector<gpu::uvec2> ranges;
    std::vector<gpu::uvec4> triangles;
    for (uint32_t i = 0; i < around.size(); ++i) {
        if (world.particles[i].body != NO_INDEX) continue;
        ranges.push_back({static_cast<uint32_t>(triangles.size()), static_cast<uint32_t>(around[i].size())});
        triangles.insert(triangles.end(), around[i].begin(), around[i].end());
    }
    clothRanges = {"clothRanges", std::span<const gpu::uvec2>(ranges)};
    clothTriangles = {"clothTriangles", std::span<const gpu::uvec4>(triangles)};
}

void ForceStage::addBuffers(BufferTable& table)
{
    table.add(Lifetime::Constant, forceFields, gustWaves, moverDrags, clothRanges, clothTriangles);
    table.add(Lifetime::Scratch, moverAccelerations);
}

void ForceStage::find(Recorder& recorder) const
{
    recorder.perElement(movers_, parameters_.moverCount);
}

void ForceStage::actOnFluids(Recorder& recorder) const
{
    if (hasFluids_) recorder.decided(fluids_, DISPATCH_SLOTS);
}

}  // namespace knuckle
