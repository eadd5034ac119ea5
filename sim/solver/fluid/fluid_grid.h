#pragma once

#include <algorithm>

#include "sim/gpu/kernel.h"

namespace knuckle {

/// Kernels of the variant FLUIDS work on the neighbour grid of fluids: what they declare of a grid is that one's.
inline Renames gridRenames(const Defines& variant)
{
    if (std::ranges::none_of(variant, [](const auto& define) { return define.first == "FLUIDS"; })) return {};
    return {
        {"cell", "fluidCell"}, {"particleCells", "fluidParticleCells"}, {"searchPositions", "fluidSearchPositions"}};
}

}  // namespace knuckle
