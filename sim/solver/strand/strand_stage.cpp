#include "sim/solver/strand/strand_stage.h"

#include <algorithm>
#include <bit>
#include <limits>

#include "sim/solver/loop_rounds.h"

namespace knuckle {

namespace {

// A soft distance that may tear does so at this multiple of its length.
constexpr float TEAR_STRETCH = 1.5f;

// Contacts of ropes with colliders, in masses of a node and of its load. The stiffer they are, the more of them is
// rounding; so a load sinks in by what it would fall in a substep over that part of a diameter.
constexpr float USUAL_ACCELERATION = 9.81f;  // [m/s2]
constexpr float MOST_SAG = 0.005f;           // [diameters]
constexpr float MOST_STIFFNESS = 0.3f;       // of the load: beyond it, few iterations do not settle
constexpr float LEAST_STIFFNESS = 30.0f;     // of the node: ropes without loads

constexpr float NEVER = std::numeric_limits<float>::max();

/// Per body, how many ends and nodes of strands are its particles: its mass is split over them.
std::vector<uint32_t> nodeCounts(const World& world)
{
    std::vector<uint32_t> counts(world.bodies.size(), 0);
    for (const Strand& strand : world.strands)
        for (uint32_t particle : strand.particles)
            if (world.particles[particle].body != NO_INDEX) ++counts[world.particles[particle].body];
    return counts;
}

/// The largest weight of the bodies and heavy nodes of an assembly with strands, over that of its lightest node.
float heaviestLoad(const World& world)
{
    std::vector<float> loads(world.assemblyCount, 0.0f), lightest(world.assemblyCount, NEVER);
    for (const Body& body : world.bodies)
        if (body.motion != Motion::Fixed) loads[body.assembly] += body.mass;
    for (const Strand& strand : world.strands)
        for (const uint32_t index : strand.particles) {
            const Particle& particle = world.particles[index];
            if (particle.body != NO_INDEX || particle.pinned) continue;
            lightest[particle.assembly] = std::min(lightest[particle.assembly], particle.mass);
            loads[particle.assembly] = std::max(loads[particle.assembly], particle.mass);
        }
    float heaviest = 0.0f;
    for (size_t a = 0; a < loads.size(); ++a)
        if (lightest[a] < NEVER) heaviest = std::max(heaviest, loads[a] / lightest[a]);
    return heaviest;
}

/// Per particle, whether its contacts with colliders are solved with its rope: it is loose and no thread of a cloth,
/// which cross.
std::vector<bool> ofRopes(const World& world)
{
    std::vector<uint32_t> threads(world.particles.size(), 0);
    for (const Strand& strand : world.strands)
        if (strand.kind == DistanceKind::Stretch)
            for (const uint32_t particle : strand.particles) ++threads[particle];
    std::vector<bool> out;
    for (size_t p = 0; p < threads.size(); ++p)
        out.push_back(threads[p] == 1 && world.particles[p].body == NO_INDEX && !world.particles[p].pinned);
    return out;
}

bool touchesAny(const World& world)
{
    return !world.colliders.empty() && std::ranges::count(ofRopes(world), true) > 0;
}

struct Uploads {
    std::vector<gpu::uvec4> strands, nodes;
    std::vector<gpu::uvec2> releases;
    std::vector<gpu::vec4> links;

    void add(const World& world, const Strand& strand, const std::vector<uint32_t>& counts,
             const std::vector<gpu::ParticleRank>& ranks)
    {
        const auto first = static_cast<uint32_t>(nodes.size());
        for (uint32_t index : strand.particles) {
            const Particle& particle = world.particles[index];
            const float inverseMass = particle.body == NO_INDEX ? 1.0f / particle.mass
                                                                : static_cast<float>(counts[particle.body]);
            nodes.push_back({ranks[index].mover, ranks[index].rank, index, std::bit_cast<uint32_t>(inverseMass)});
        }
        for (float length : strand.restLengths) {
            const bool tears = strand.tearForce < NEVER;
            const bool soft = strand.kind != DistanceKind::Stretch;
            links.push_back({length, strand.compliance, std::min(strand.tearForce, NEVER),
                             tears && soft ? TEAR_STRETCH * length : NEVER});
        }
        links.push_back({});
        const uint32_t assembly = world.particles[strand.particles.front()].assembly;
        strands.push_back({first, static_cast<uint32_t>(nodes.size()) - 1, assembly, 0});
        releases.push_back(
            {world.settings.substepAt(strand.startRelease), world.settings.substepAt(strand.endRelease)});
    }
};

}  // namespace

bool StrandStage::isNeeded(const World& world)
{
    return world.settings.solver == SolverKind::Impulse && !world.strands.empty();
}

StrandStage::StrandStage(const StageSetup& setup)
    : load_(heaviestLoad(setup.world)), touches_(touchesAny(setup.world)),
      letsGo_(std::ranges::any_of(setup.world.strands, &Strand::letsGo))
{
}

void StrandStage::upload(const StageSetup& setup)
{
    const World& world = setup.world;
    const std::vector<uint32_t> counts = nodeCounts(world);
    order_ = strandOrder(world);
    size_t longest = 0;
    for (const Strand& strand : world.strands) longest = std::max(longest, strand.particles.size());
    // Whether it rests, up and down.
    checkLoopRounds(setup.gpu, 3 * (longest + 1), fmt::format("a rope or thread of {} particles", longest));
    Uploads uploads;
    for (uint32_t index : order_.strands) {
        if (colors_.size() <= order_.colors[index])
            colors_.push_back({static_cast<uint32_t>(uploads.strands.size()), 0, false});
        Color& color = colors_.back();
        Strand strand = world.strands[index];
        if (order_.reversed[index]) {
            std::reverse(strand.particles.begin(), strand.particles.end());
            std::reverse(strand.restLengths.begin(), strand.restLengths.end());
            std::swap(strand.startRelease, strand.endRelease);
        }
        uploads.add(world, strand, counts, setup.layout.ranks);
        color.end = static_cast<uint32_t>(uploads.strands.size());
        for (uint32_t particle : world.strands[index].particles)
            if (world.particles[particle].body != NO_INDEX) color.hasBodies = true;
    }
    strands = {"strands", std::span<const gpu::uvec4>(uploads.strands)};
    distanceNodes = {"distanceNodes", std::span<const gpu::uvec4>(uploads.nodes)};
    distanceLinks = {"distanceLinks", std::span<const gpu::vec4>(uploads.links)};
    strandReleases = {"strandReleases", std::span<const gpu::uvec2>(uploads.releases)};
    distanceStates = {"distanceStates", uploads.nodes.size()};
    distanceFactors = {"distanceFactors", (heavy_ ? 8 : 4) * uploads.nodes.size()};
    if (touches_) uploadRopes(setup, uploads.nodes);
}

void StrandStage::uploadRopes(const StageSetup& setup, const std::vector<gpu::uvec4>& nodes)
{
    constexpr size_t NODE_CONTACT_TEXELS = 5;  // shaders/sim/strand/node_contacts.glsl
    const World& world = setup.world;
    const std::vector<bool> ofRope = ofRopes(world);
    std::vector<uint32_t> own, movers(setup.layout.moverCount(), 0);
    for (size_t s = 0; s < order_.starts.size(); ++s) {
        if (world.strands[s].kind != DistanceKind::Stretch) continue;
        for (size_t k = 0; k < world.strands[s].particles.size(); ++k) {
            const auto node = static_cast<uint32_t>(order_.starts[s] + k);
            if (!ofRope[nodes[node].z]) continue;
            own.push_back(node);
            movers[nodes[node].x] = node + 1;
        }
    }
    ropeNodes = {"ropeNodes", std::span<const uint32_t>(own)};
    ropeMovers = {"ropeMovers", std::span<const uint32_t>(movers)};
    nodeContacts = {"nodeContacts", NODE_CONTACT_TEXELS * nodes.size()};
    const float h = setup.parameters.substepTime;
    const float fall = USUAL_ACCELERATION * h * h / (MOST_SAG * setup.parameters.diameter);
    contactStiffness_ = std::max(load_ * std::min(fall, MOST_STIFFNESS), LEAST_STIFFNESS);
    contactHold_ = std::max(load_, LEAST_STIFFNESS);
}

void StrandStage::addBuffers(BufferTable& table)
{
    table.add(Lifetime::Constant, strands, distanceNodes, distanceLinks, strandReleases);
    if (touches_) {
        table.add(Lifetime::Constant, ropeNodes, ropeMovers);
        table.add(Lifetime::Scratch, nodeContacts);
    }
    table.add(Lifetime::State, distanceStates);
    ElementType doubles{32, 16, ElementType::Scalar::Float, GL_DOUBLE_VEC4};
    table.add("distanceFactors", distanceFactors, heavy_ ? doubles : elementType<gpu::vec4>(), Lifetime::Scratch);
}

void StrandStage::solve(Recorder& recorder, bool first) const
{
    if (touches_) recordTouch(recorder, first ? firstTouch_ : laterTouch_);
    for (const Color& color : colors_) {
        const Kernel& kernel = color.hasBodies ? (first ? firstWithBodies_ : laterWithBodies_)
                                               : (first ? first_ : later_);
        glProgramUniform2ui(kernel.program(), 0, color.begin, color.end);
        recorder.groups(kernel, (color.end - color.begin + DISTANCE_GROUP_SIZE - 1) / DISTANCE_GROUP_SIZE);
    }
    if (touches_) recordTouch(recorder, first ? firstPush_ : laterPush_);
}

void StrandStage::recordTouch(Recorder& recorder, const Kernel& kernel) const
{
    glProgramUniform2f(kernel.program(), 0, contactStiffness_, contactHold_);
    recorder.perElement(kernel, ropeNodes.size());
}

void StrandStage::measure(Measures& out, const World& world, const ParticleState& particles) const
{
    measureDistances(out, world, particles, tornDistances(world));
}

std::vector<bool> StrandStage::tornDistances(const World& world) const
{
    std::vector<bool> torn;
    const std::vector<gpu::vec4> states = distanceStates.download();
    for (size_t s = 0; s < world.strands.size(); ++s) {
        const size_t count = world.strands[s].restLengths.size();
        for (size_t k = 0; k < count; ++k) torn.push_back(states[stateOf(world, s, k)].z != 0.0f);
    }
    return torn;
}

size_t StrandStage::stateOf(const World& world, size_t strand, size_t distance) const
{
    return order_.stateOf(world, strand, distance);
}

}  // namespace knuckle
