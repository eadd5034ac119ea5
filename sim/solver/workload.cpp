#include "sim/solver/workload.h"

#include <algorithm>
#include <cmath>

namespace knuckle {

namespace {

// Time for a particle in a substep [us], on one core of 2.6 GHz: docs/decisions.
constexpr double BODY_MICROSECONDS = 0.15;
constexpr double LOOSE_MICROSECONDS = 2.0;  // grains, cloth, soft bodies
constexpr double FLUID_MICROSECONDS = 0.75;
constexpr double PAPER_MICROSECONDS = 0.25;  // in one iteration

/// With prediction and finish; a search, which is more than half of it, is due in each second or third substep.
constexpr double SEARCH_DISPATCHES = 14.0;
constexpr double FLUID_DISPATCHES = 8.0;

/// Dispatches of one iteration of the paper's solver; eq. 10 halves a body's links step by step, for centres and for
/// matrices.
double paperIteration(const World& world)
{
    uint32_t longest = 1;
    for (const Body& body : world.bodies) longest = std::max(longest, body.linkCount);
    const bool steps = world.settings.reduction == ReductionKind::Steps;
    return 5.0 + (steps ? 3.0 + 2.0 * std::ceil(std::log2(longest)) : 0.0);
}

}  // namespace

Workload stepWorkload(const World& world)
{
    const Settings& s = world.settings;
    const double fluids = world.fluidCount;
    double inBodies = 0.0;
    for (const Particle& p : world.particles) inBodies += p.body != NO_INDEX ? 1.0 : 0.0;
    const double loose = static_cast<double>(world.particles.size()) - fluids - inBodies;
    Workload substep{fluids > 0.0 ? FLUID_DISPATCHES : 0.0, fluids * FLUID_MICROSECONDS / 1000.0};
    if (s.solver == SolverKind::Paper) {
        const double iterations = s.iterations + s.stabilization;
        substep = substep + Workload{SEARCH_DISPATCHES + iterations * paperIteration(world),
                                     iterations * (inBodies + loose) * PAPER_MICROSECONDS / 1000.0};
    } else {
        const double others = (world.clusters.empty() ? 0.0 : 4.0) + (world.strands.empty() ? 0.0 : 8.0);
        substep = substep + Workload{SEARCH_DISPATCHES + s.iterations * (4.0 + others),
                                     (inBodies * BODY_MICROSECONDS + loose * LOOSE_MICROSECONDS) / 1000.0};
    }
    return substep * s.substeps;
}

}  // namespace knuckle
