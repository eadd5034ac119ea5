#pragma once

#include <string>
#include <vector>

#include "sim/solver/carry/element_maps.h"

namespace knuckle {

/// The state of a world's stages after so many substeps in which what another world's stages have as well is as it is
/// there, and all else as in this world's stages. Contacts are looked for at once; what sleeps wakes.
/// @param substep of the later stages: the number of substeps since the start.
/// @throws std::logic_error if fluid has drained away and the later world has no pools that could hold it.
StagesState carriedOver(const StagesOf& before, const StagesOf& after, const Counterparts& same, uint32_t substep);

/// Names of all buffers of which carriedOver() decides something, for a test that finds one that is forgotten.
std::vector<std::string> carriedBuffers();

}  // namespace knuckle
