#pragma once

#include <algorithm>
#include <cmath>
#include <string>

#include "sim/solver/carry/element_maps.h"
#include "sim/solver/state_values.h"

namespace knuckle {

/// What the parts of carriedOver() work on.
struct Carrying {
    const StagesOf& before;
    const StagesOf& after;
    const Counterparts& same;
    const ElementMaps& maps;
    const StagesState& from;
    StagesState& to;
    uint32_t earlierSubstep, substep;  ///< Done so far, in each of both.

    bool has(const std::string& name) const { return from.buffers.contains(name) && to.buffers.contains(name); }
    /// How much longer a substep is now.
    double substepRatio() const
    {
        return double{after.stages.parameters.substepTime} / double{before.stages.parameters.substepTime};
    }
    /// A substep up to now, counted in those of the later stages.
    uint32_t rescaled(uint32_t earlier) const
    {
        const double ago = (static_cast<double>(earlierSubstep) - static_cast<double>(earlier)) / substepRatio();
        return static_cast<uint32_t>(std::max(0.0, static_cast<double>(substep) - std::ceil(ago - 1e-6)));
    }
};

/// Impulses of the last contacts, in the half of the lists that the next search takes for the old one.
void carryContacts(const Carrying& carrying);
/// What is let go or limp, when that happens, and what is caught.
void carryReleases(const Carrying& carrying);
/// Order of assemblies, torn joints, pools of emitters, counters. @throws as carriedOver().
void carryCounted(const Carrying& carrying);
/// Points of foam, spray and bubbles.
void carryFoam(const Carrying& carrying);

}  // namespace knuckle
