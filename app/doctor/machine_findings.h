#pragma once

#include "app/doctor/finding.h"

namespace knuckle {

/// Cores and driver threads, memory, limits, the cache of shaders, displays. @param software whether the CPU computes.
Findings findMachine(bool software);

/// Whether films, pictures with text, and scenes by their short paths can be had.
Findings findFiles();

}  // namespace knuckle
