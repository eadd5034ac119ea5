#include <algorithm>
#include <stdexcept>

#include "shared/constants.h"
#include "sim/solver/carry/carrying.h"

namespace knuckle {

namespace {

/// Velocities are of first order in the next substep where nothing is known of the last.
void carryAssemblies(const Carrying& c)
{
    const auto from = readState<gpu::uvec2>(c.from, "assemblyState");
    auto to = readState<gpu::uvec2>(c.to, "assemblyState");
    const std::vector<uint32_t>& assemblies = c.maps.of(Per::Assembly);
    for (size_t a = 0; a < assemblies.size(); ++a) {
        const uint32_t was = assemblies[a];
        if (was == NO_INDEX || c.substepRatio() != 1.0) {
            to[a] = {c.substep > 0 ? c.substep - 1 : NO_SUBSTEP, 1};
            continue;
        }
        const bool never = from[was].x == NO_SUBSTEP;
        to[a] = {never ? NO_SUBSTEP : c.rescaled(from[was].x), from[was].y};
    }
    writeState(c.to, "assemblyState", to);
}

void carryTorn(const Carrying& c)
{
    const auto from = readState<uint32_t>(c.from, "jointFreedoms");
    auto to = readState<uint32_t>(c.to, "jointFreedoms");
    const std::vector<uint32_t>& joints = c.maps.of(Per::Joint);
    for (size_t k = 0; k < joints.size(); ++k)
        if (joints[k] != NO_INDEX && from[joints[k]] == JOINT_NONE) to[k] = JOINT_NONE;
    writeState(c.to, "jointFreedoms", to);

    const auto links = readState<gpu::uvec2>(c.from, "particleLinks");
    auto later = readState<gpu::uvec2>(c.to, "particleLinks");
    const std::vector<uint32_t>& particles = c.maps.of(Per::Particle);
    for (size_t p = 0; p < particles.size(); ++p)
        if (particles[p] != NO_INDEX) later[p].y = std::min(later[p].y, links[particles[p]].y);
    writeState(c.to, "particleLinks", later);
}

/// Bodies that a torn joint has let touch again do so.
void carryFilters(const Carrying& c)
{
    const auto bodiesFrom = c.before.stages.search.bodyFilters.download();
    const auto bodiesTo = c.after.stages.search.bodyFilters.download();
    const auto from = readState<uint32_t>(c.from, "filterBits");
    auto to = readState<uint32_t>(c.to, "filterBits");
    for (uint32_t b = 0; b < c.same.bodies.size(); ++b) {
        const uint32_t was = c.same.bodies[b];
        if (was == NO_INDEX) continue;
        for (const uint32_t other : c.before.world.bodies[was].filtered) {
            const uint32_t bit = other - bodiesFrom[was].y, place = bodiesFrom[was].x + bit;
            if ((from[place / 32] >> place % 32 & 1u) != 0 || c.after.world.bodies[b].filtered.empty()) continue;
            const uint32_t later = bodiesTo[b].x + bit;
            to[later / 32] &= ~(1u << later % 32);
        }
    }
    writeState(c.to, "filterBits", to);
}

uint32_t inactiveFilled(const std::vector<gpu::vec4>& positions, uint32_t first, uint32_t end)
{
    uint32_t count = 0;
    for (uint32_t p = first; p < end; ++p) count += positions[p].w != 0.0f ? 1 : 0;
    return count;
}

/// The particles of a pool that are in both, in the order of the earlier list; the others before them.
std::vector<uint32_t> poolOf(const Carrying& c, uint32_t emitter, uint32_t firstParticle,
                             const std::vector<uint32_t>& earlierOrder, const std::vector<gpu::Emitter>& earlier)
{
    const uint32_t count = c.after.world.emitters[emitter].pool;
    std::vector<uint32_t> order;
    for (uint32_t p = firstParticle; p < firstParticle + count; ++p)
        if (c.same.particles[p] == NO_INDEX) order.push_back(p);
    if (order.size() == count) return order;
    const uint32_t was = c.same.emitters[emitter];
    const uint32_t oldFirst = c.same.particles[firstParticle];  // pools agree in their first particles
    for (uint32_t k = 0; k < earlier[was].poolCount; ++k) {
        const uint32_t index = earlierOrder[earlier[was].poolStart + k] - oldFirst;
        if (index < count) order.push_back(firstParticle + index);
    }
    return order;
}

void carryPools(const Carrying& c)
{
    const gpu::StepParameters &then = c.from.parameters, &now = c.to.parameters;
    const auto positions = readState<gpu::vec4>(c.to, "positions");
    const uint32_t filledEnd = now.particleCount + now.fluidFilled;
    const uint32_t drained = inactiveFilled(positions, now.particleCount, filledEnd);
    if (!c.after.stages.emitters) {
        if (drained > 0) throw std::logic_error("fluid has drained away, and this world has no pool to hold it");
        return;
    }
    auto order = readState<uint32_t>(c.to, "poolOrder"), inactive = readState<uint32_t>(c.to, "poolInactive");
    const bool had = c.before.stages.emitters.has_value();
    const auto earlier = had ? c.before.stages.emitters->emitters.download() : std::vector<gpu::Emitter>();
    auto earlierOrder = had ? readState<uint32_t>(c.from, "poolOrder") : std::vector<uint32_t>();
    // The half that the last step has written (shaders/sim/emitter/emitters.glsl).
    const uint32_t steps = c.earlierSubstep / then.substeps, half = steps % 2 == 0 ? then.poolCapacity : 0;
    if (had && c.earlierSubstep > 0)
        earlierOrder.erase(earlierOrder.begin(), earlierOrder.begin() + static_cast<std::ptrdiff_t>(half));
    uint32_t particle = filledEnd, active = 0;
    const auto emitters = c.after.stages.emitters->emitters.download();
    for (uint32_t e = 0; e < emitters.size(); ++e) {
        const std::vector<uint32_t> pool = poolOf(c, e, particle, earlierOrder, earlier);
        for (uint32_t k = 0; k < pool.size(); ++k) {
            const uint32_t place = emitters[e].poolStart + k;
            order[place] = order[now.poolCapacity + place] = pool[k];
            inactive[place] = positions[pool[k]].w != 0.0f ? 1 : 0;
            active += 1 - inactive[place];
        }
        particle += emitters[e].poolCount;
    }
    writeState(c.to, "poolOrder", order);
    writeState(c.to, "poolInactive", inactive);
    writeState(c.to, "fluidTotals", std::vector<uint32_t>{active, drained});
    auto dispatches = readState<gpu::uvec4>(c.to, "dispatches");
    dispatches[DISPATCH_SLOTS] = {groupsFor(filledEnd + active), 1, 1, 0};
    writeState(c.to, "dispatches", dispatches);
}

void carryCounters(const Carrying& c)
{
    gpu::Counters counters{};
    counters.substep = c.substep;
    counters.due = counters.freeMoved = 1;
    writeState(c.to, "countersBlock", std::vector{counters});
}

}  // namespace

void carryCounted(const Carrying& c)
{
    carryAssemblies(c);
    carryTorn(c);
    carryFilters(c);
    carryPools(c);
    carryCounters(c);
}

}  // namespace knuckle
