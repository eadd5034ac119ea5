#include "render/ropes/rope_pass.h"

#include <span>
#include <vector>

#include "render/color_word.h"
#include "render/looks/picture_defines.h"
#include "render/quantities/color_scale.h"
#include "render/render_groups.h"
#include "render/spheres/palette.h"
#include "render/unseen.h"
#include "shared/frame_types.h"
#include "shared/matter_types.h"
#include "sim/gpu/filled_buffer.h"
#include "sim/solver/strand/strand_order.h"

namespace knuckle {

namespace {

constexpr uint32_t RINGS = TUBE_RINGS + 2 * TUBE_CAP_RINGS;

/// Triangles of the rings of one link.
std::vector<uint32_t> ringIndices()
{
    std::vector<uint32_t> indices;
    for (uint32_t ring = 0; ring + 1 < RINGS; ++ring)
        for (uint32_t side = 0; side < TUBE_SIDES; ++side) {
            const uint32_t a = ring * (TUBE_SIDES + 1) + side, b = a + TUBE_SIDES + 1;
            indices.insert(indices.end(), {a, a + 1, b, a + 1, b + 1, b});
        }
    return indices;
}

/// Of its first loose particle: its ends may be of bodies.
float colorOf(const World& world, const Strand& strand, const std::vector<uint32_t>& colors)
{
    uint32_t of = strand.particles.front();
    for (const uint32_t particle : strand.particles)
        if (world.particles[of].body != NO_INDEX) of = particle;
    return static_cast<float>(colors[of] & COLOR_BITS);
}

bool isSeen(const Strand& strand, const std::vector<uint32_t>& unseen)
{
    for (const uint32_t particle : strand.particles)
        if (!hasBit(unseen, particle)) return true;
    return false;
}

}  // namespace

RopePass::RopePass(const Gpu& gpu, BufferTable& table, const World& world, const RenderSettings& settings,
                   const RenderTargets& targets)
{
    if (world.drawn.ropes.empty()) return;
    Defines defines;
    if (upload(table, world, settings)) defines.push_back({"TEARS", "1"});
    place_ = Kernel(gpu, table, "render/ropes/tube_frames.comp", defines);
    Defines looks;
    if (settings.colorBy == ColorBy::Speed) looks = colorDefines(world, settings);
    std::vector<std::string> reads = {"tubeFrames", "tubeLooks", "tubeNodes", "velocities"};
    if (targets.hasLayers()) {
        earlier_.add(table, frames_);
        reads.push_back("earlierTubeFrames");
    }
    tubes_ = DrawPass(gpu, table, {"ropes/tube", "ropes/tube", joined({looks, targets.layerDefines(true)})}, reads,
                      targets.geometry, GL_BACK);
    looks.push_back({"LIGHT_VIEW", "1"});
    // Only what is turned away from the light casts shadows, so that lit faces do not shade themselves.
    shadow_ = DrawPass(gpu, table, {"ropes/tube", "ropes/tube_shadow", looks}, reads, targets.shadowMap, GL_FRONT);
}

bool RopePass::upload(BufferTable& table, const World& world, const RenderSettings& settings)
{
    const std::vector<uint32_t> colors = particleColors(world, settings), unseen = unseenBits(world);
    const bool mayTear = canTear(world);
    const StrandOrder order = mayTear ? strandOrder(world) : StrandOrder();
    std::vector<gpu::vec4> ropes, looks;
    std::vector<gpu::uvec2> nodes;
    for (const uint32_t index : world.drawn.ropes) {
        const Strand& strand = world.strands[index];
        if (!isSeen(strand, unseen)) continue;
        const size_t count = strand.particles.size();
        const Vector3f heading = (world.particles[strand.particles[1]].position -
                                  world.particles[strand.particles[0]].position)
                                     .stableNormalized();
        ropes.push_back({static_cast<float>(nodes.size()), static_cast<float>(count), 0.0f, 0.0f});
        ropes.push_back({heading.x(), heading.y(), heading.z(), 0.0f});
        float length = 0.0f;
        for (size_t k = 0; k < count; ++k) {
            const bool tears = mayTear && k + 1 < count;
            const float link = k + 1 < count ? strand.restLengths[k] : 0.0f;
            nodes.push_back(
                {strand.particles[k], tears ? static_cast<uint32_t>(order.stateOf(world, index, k)) : NEVER_TORN});
            looks.push_back({length, link, colorOf(world, strand, colors), 0.0f});
            length += link;
        }
    }
    const std::vector<uint32_t> indices = ringIndices();
    const gpu::DrawElementsArguments draw{static_cast<uint32_t>(indices.size()), static_cast<uint32_t>(nodes.size()), 0,
                                          0, 0};
    ropes_ = filledBuffer("tubeRopes", ropes);
    looks_ = filledBuffer("tubeLooks", looks);
    nodes_ = filledBuffer("tubeNodes", nodes);
    indices_ = filledBuffer("tubeIndices", indices);
    draws_ = {"tubeDraws", std::span<const gpu::DrawElementsArguments>(&draw, 1)};
    frames_ = {"tubeFrames", 3 * nodes.size()};
    table.add(Lifetime::Constant, ropes_, looks_, nodes_);
    table.add(Lifetime::Scratch, frames_);
    return mayTear;
}

void RopePass::update(KernelTimer& timer)
{
    const auto count = static_cast<uint32_t>(ropes_.size() / 2);
    if (count > 0) place_.dispatch(timer, renderGroups(count));
}

void RopePass::drawShadow(KernelTimer& timer) const
{
    if (ropes_.size() > 0) shadow_.drawIndexed(timer, indices_, draws_, {0, 1, GL_FRONT});
}

void RopePass::draw(KernelTimer& timer) const
{
    if (ropes_.size() > 0) tubes_.drawIndexed(timer, indices_, draws_, {0, 1, GL_BACK});
}

}  // namespace knuckle
