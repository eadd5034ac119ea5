#include <algorithm>
#include <map>

#include "shared/constants.h"
#include "shared/drive_types.h"
#include "sim/solver/carry/carrying.h"

namespace knuckle {

namespace {

bool responds(uint32_t state)
{
    return state == MOVER_DYNAMIC || state == MOVER_ASLEEP;
}

/// Whether a body is held or animated in the same way in both worlds, so that it goes on as it was.
bool heldAlike(const Carrying& c, uint32_t body)
{
    const uint32_t earlier = c.same.bodies[body];
    return earlier != NO_INDEX && c.before.world.bodies[earlier].motion == c.after.world.bodies[body].motion;
}

void carryStates(const Carrying& c)
{
    const auto from = readState<uint32_t>(c.from, "moverStates");
    auto to = readState<uint32_t>(c.to, "moverStates");
    for (uint32_t b = 0; b < c.after.world.bodies.size(); ++b) {
        if (!heldAlike(c, b) || neverResponds(c.after.world.bodies[b])) continue;
        const uint32_t was = from[c.same.bodies[b]];
        to[b] = was == MOVER_ASLEEP ? MOVER_DYNAMIC : was;
    }
    writeState(c.to, "moverStates", to);
}

/// When bodies that were caught are let go again; of others nothing.
std::map<uint32_t, uint32_t> releasesAgain(const Carrying& c)
{
    std::map<uint32_t, uint32_t> again;
    if (!c.has("puppetStates")) return again;
    const World& world = c.after.world;
    const auto states = readState<gpu::uvec4>(c.to, "puppetStates");
    for (size_t p = 0; p < world.puppets.size(); ++p) {
        const Puppet& puppet = world.puppets[p];
        if (!puppet.caught || states[2 * p].x != PUPPET_CAUGHT) continue;
        for (uint32_t b = 0; b < objectOf(world, puppet).bodyCount; ++b)
            again[objectOf(world, puppet).bodyStart + b] = world.settings.substepAt(puppet.caught->releaseTimes[b]);
    }
    return again;
}

/// What was let go stays so; all else is let go when this world says, and at once if that is over.
void carryBodyReleases(const Carrying& c)
{
    if (!c.to.buffers.contains("bodyReleases")) return;
    const auto states = readState<uint32_t>(c.to, "moverStates");
    const std::map<uint32_t, uint32_t> again = releasesAgain(c);
    const auto from = c.has("bodyReleases") ? readState<gpu::uvec2>(c.from, "bodyReleases") : std::vector<gpu::uvec2>();
    auto to = readState<gpu::uvec2>(c.to, "bodyReleases");
    const std::vector<uint32_t>& held = c.maps.of(Per::Held);
    for (size_t k = 0; k < held.size(); ++k) {
        uint32_t& when = to[k].y;
        const uint32_t body = to[k].x;
        const bool known = held[k] != NO_INDEX && heldAlike(c, body);
        const uint32_t was = known ? from.at(held[k]).y : NO_SUBSTEP;
        if (known && responds(states[body])) {
            when = std::min(c.rescaled(std::min(was, c.earlierSubstep)), c.substep > 0 ? c.substep - 1 : 0);
            continue;
        }
        if (const auto caught = again.find(body); caught != again.end()) when = caught->second;
        if (when < c.substep || was == c.earlierSubstep) when = c.substep;
    }
    writeState(c.to, "bodyReleases", to);
}

/// Per animated body, when the scene makes it limp: at first, after it was caught.
std::vector<gpu::uvec2> limpTimes(const StagesOf& of)
{
    const Settings& settings = of.world.settings;
    const std::vector<uint32_t>& first = of.stages.layout.firstAnimated;
    std::vector<gpu::uvec2> times(first.back(), {NO_SUBSTEP, NO_SUBSTEP});
    for (const Puppet& puppet : of.world.puppets)
        for (uint32_t b = 0; b < objectOf(of.world, puppet).bodyCount; ++b)
            times[first[puppet.animation] + b] = {
                settings.substepAt(puppet.limpTimes[b]),
                puppet.caught ? settings.substepAt(puppet.caught->limpTimes[b]) : NO_SUBSTEP};
    return times;
}

/// What something that happened has made limp stays so.
void carryLimp(const Carrying& c)
{
    if (!c.has("limpSubsteps")) return;
    const std::vector<gpu::uvec2> said = limpTimes(c.before);
    const auto from = readState<gpu::uvec4>(c.from, "limpSubsteps");
    auto to = readState<gpu::uvec4>(c.to, "limpSubsteps");
    const std::vector<uint32_t>& animated = c.maps.of(Per::Animated);
    for (size_t k = 0; k < animated.size(); ++k) {
        const uint32_t was = animated[k];
        if (was == NO_INDEX) continue;
        if (from[was].x < said[was].x) to[k].x = std::min(to[k].x, c.rescaled(from[was].x));
        if (from[was].y < said[was].y) to[k].y = std::min(to[k].y, c.rescaled(from[was].y));
    }
    writeState(c.to, "limpSubsteps", to);
}

/// A puppet that this world will catch later waits for that.
void carryPuppets(const Carrying& c)
{
    if (!c.has("puppetStates")) return;
    const auto from = readState<gpu::uvec4>(c.from, "puppetStates");
    auto to = readState<gpu::uvec4>(c.to, "puppetStates");
    const std::vector<uint32_t>& puppets = c.maps.of(Per::Puppet);
    for (size_t p = 0; p < puppets.size(); ++p) {
        if (puppets[p] == NO_INDEX) continue;
        to[2 * p] = from[2 * size_t{puppets[p]}];
        to[2 * p + 1] = from[2 * size_t{puppets[p]} + 1];
        to[2 * p].y = c.rescaled(to[2 * p].y);
        const auto& caught = c.after.world.puppets[p].caught;
        if (caught && c.after.world.settings.substepAt(caught->time) >= c.substep) to[2 * p].x = PUPPET_FIRST;
    }
    writeState(c.to, "puppetStates", to);
}

}  // namespace

void carryReleases(const Carrying& c)
{
    carryStates(c);
    carryPuppets(c);
    carryBodyReleases(c);
    carryLimp(c);
}

}  // namespace knuckle
