#include "sim/solver/rope/upload_distances.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <numeric>

namespace knuckle {

namespace {

constexpr float NEVER = std::numeric_limits<float>::max();

bool isFixed(const World& world, uint32_t particle)
{
    const uint32_t body = world.particles[particle].body;
    return body != NO_INDEX && world.bodies[body].motion == Motion::Fixed;
}

/// Whether it is uploaded the other way round: the sweep begins at its end, which is better free.
bool isReversed(const World& world, const Strand& strand)
{
    return isFixed(world, strand.particles.back());
}

/// Per strand, its phase: the first whose distanceRows share no particle with it that can move.
std::vector<uint32_t> phasesOf(const World& world)
{
    std::vector<std::vector<uint32_t>> taken(world.particles.size());
    std::vector<uint32_t> phases;
    for (const Strand& strand : world.strands) {
        std::vector<uint32_t> others;
        for (uint32_t particle : strand.particles)
            others.insert(others.end(), taken[particle].begin(), taken[particle].end());
        uint32_t phase = 0;
        while (std::find(others.begin(), others.end(), phase) != others.end()) ++phase;
        for (uint32_t particle : strand.particles)
            if (!isFixed(world, particle)) taken[particle].push_back(phase);
        phases.push_back(phase);
    }
    return phases;
}

/// Per body, how many ends and nodes of distanceRows are its particles: its mass is split over them.
std::vector<uint32_t> nodeCounts(const World& world)
{
    std::vector<uint32_t> counts(world.bodies.size(), 0);
    for (const Strand& strand : world.strands)
        for (uint32_t particle : strand.particles)
            if (world.particles[particle].body != NO_INDEX) ++counts[world.particles[particle].body];
    return counts;
}

struct Rows {
    std::vector<gpu::uvec4> distanceRows, nodes;
    std::vector<gpu::vec4> links;

    void add(const World& world, const Strand& strand, const std::vector<uint32_t>& counts,
             const std::vector<gpu::uvec2>& places)
    {
        const auto first = static_cast<uint32_t>(nodes.size());
        for (uint32_t index : strand.particles) {
            const Particle& particle = world.particles[index];
            const float share = isFixed(world, index)        ? 0.0f
                                : particle.body == NO_INDEX  ? 1.0f / particle.mass
                                                             : static_cast<float>(counts[particle.body]);
            nodes.push_back({places[index].x, places[index].y, index, std::bit_cast<uint32_t>(share)});
        }
        for (float length : strand.restLengths) {
            const bool tears = strand.tearForce < NEVER;
            const bool soft = strand.kind != StrandKind::Stretch;
            links.push_back({length, strand.compliance, std::min(strand.tearForce, NEVER),
                             tears && soft ? TEAR_STRETCH * length : NEVER});
        }
        links.push_back({});
        const uint32_t assembly = world.particles[strand.particles.front()].assembly;
        distanceRows.push_back({first, static_cast<uint32_t>(nodes.size()) - 1, assembly, 0});
    }
};

}  // namespace

void uploadDistances(SolverBuffers& out, const World& world)
{
    const std::vector<uint32_t> phases = phasesOf(world), counts = nodeCounts(world);
    const std::vector<gpu::uvec2> places = out.particleRanks.download();
    std::vector<uint32_t> order(world.strands.size());
    std::iota(order.begin(), order.end(), 0u);
    // Of a phase the long ones first: the threads of a vector then do as much.
    std::stable_sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) {
        if (phases[a] != phases[b]) return phases[a] < phases[b];
        return world.strands[a].particles.size() > world.strands[b].particles.size();
    });
    Rows rows;
    out.distanceStarts.resize(world.strands.size());
    for (uint32_t index : order) {
        if (out.distanceColors.size() <= phases[index])
            out.distanceColors.push_back({static_cast<uint32_t>(rows.distanceRows.size()), 0, false});
        DistanceColor& phase = out.distanceColors.back();
        out.distanceStarts[index] = static_cast<uint32_t>(rows.nodes.size());
        Strand strand = world.strands[index];
        if (isReversed(world, strand)) {
            std::reverse(strand.particles.begin(), strand.particles.end());
            std::reverse(strand.restLengths.begin(), strand.restLengths.end());
        }
        rows.add(world, strand, counts, places);
        phase.end = static_cast<uint32_t>(rows.distanceRows.size());
        for (uint32_t particle : world.strands[index].particles)
            if (world.particles[particle].body != NO_INDEX) phase.hasBodies = true;
    }
    out.hasParticleImpulses = out.hasParticleImpulses || !world.strands.empty();
    out.distanceRows = {"distanceRows", std::span<const gpu::uvec4>(rows.distanceRows)};
    out.distanceNodes = {"distanceNodes", std::span<const gpu::uvec4>(rows.nodes)};
    out.distanceLinks = {"distanceLinks", std::span<const gpu::vec4>(rows.links)};
    out.distanceStates = {"distanceStates", rows.nodes.size()};
    out.distanceFactors = {"distanceFactors", 4 * rows.nodes.size()};
}

std::vector<bool> tornDistances(const SolverBuffers& buffers, const World& world)
{
    std::vector<bool> torn;
    if (world.strands.empty()) return torn;
    const std::vector<gpu::vec4> states = buffers.distanceStates.download();
    for (size_t s = 0; s < world.strands.size(); ++s) {
        const size_t count = world.strands[s].restLengths.size();
        const bool reversed = isReversed(world, world.strands[s]);
        for (size_t k = 0; k < count; ++k)
            torn.push_back(states[buffers.distanceStarts[s] + (reversed ? count - 1 - k : k)].z != 0.0f);
    }
    return torn;
}

}  // namespace knuckle
