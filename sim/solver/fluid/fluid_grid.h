#pragma once

#include <algorithm>

#include "sim/gpu/kernel.h"

namespace knuckle {

/// Kernels of the variant FLUIDS use the fluids' own neighbour grid instead of the one that they declare.
inline Renames gridRenames(const Defines& variant)
{
    if (std::ranges::none_of(variant, [](const auto& define) { return define.first == "FLUIDS"; })) return {};
    return {
        {"cell", "fluidCell"}, {"particleCells", "fluidParticleCells"}, {"searchPositions", "fluidSearchPositions"}};
}

}  // namespace knuckle
