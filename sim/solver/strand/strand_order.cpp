#include "sim/solver/strand/strand_order.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace knuckle {

namespace {

/// Per strand, its colour: the first in which no strand shares a moving particle with it.
std::vector<uint32_t> colorsOf(const World& world)
{
    std::vector<std::vector<uint32_t>> taken(world.particles.size());
    std::vector<uint32_t> colors;
    for (const Strand& strand : world.strands) {
        std::vector<uint32_t> others;
        for (uint32_t particle : strand.particles)
            others.insert(others.end(), taken[particle].begin(), taken[particle].end());
        uint32_t color = 0;
        while (std::find(others.begin(), others.end(), color) != others.end()) ++color;
        for (uint32_t particle : strand.particles)
            if (!isFixedForEver(world, world.particles[particle])) taken[particle].push_back(color);
        colors.push_back(color);
    }
    return colors;
}

}  // namespace

StrandOrder strandOrder(const World& world)
{
    StrandOrder order;
    order.colors = colorsOf(world);
    order.strands.resize(world.strands.size());
    std::iota(order.strands.begin(), order.strands.end(), 0u);
    // In each colour the long ones come first, so that the threads of a vector do equal work.
    std::ranges::stable_sort(order.strands, [&](uint32_t a, uint32_t b) {
        if (order.colors[a] != order.colors[b]) return order.colors[a] < order.colors[b];
        return world.strands[a].particles.size() > world.strands[b].particles.size();
    });
    order.starts.resize(world.strands.size());
    for (const uint32_t strand : order.strands) {
        order.starts[strand] = order.nodeCount;
        order.nodeCount += static_cast<uint32_t>(world.strands[strand].particles.size());
    }
    for (const Strand& strand : world.strands)
        order.reversed.push_back(isFixed(world, world.particles[strand.particles.back()]));
    return order;
}

size_t StrandOrder::stateOf(const World& world, size_t strand, size_t distance) const
{
    const size_t last = world.strands[strand].restLengths.size() - 1;
    return starts[strand] + (reversed[strand] ? last - distance : distance);
}

bool canTear(const World& world)
{
    return world.settings.solver == SolverKind::Impulse && std::ranges::any_of(world.strands, [](const Strand& strand) {
               return std::isfinite(strand.tearForce) || strand.letsGo();
           });
}

}  // namespace knuckle
