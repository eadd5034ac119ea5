#pragma once

#include "sim/gpu/device/driver_threads.h"
#include "sim/world/world.h"

namespace knuckle {

/// Estimates what a step of a world costs on a software driver: within a third of the dispatches, within three times
/// the time. Substeps must be chosen (World as its builder leaves it).
Workload stepWorkload(const World& world);

}  // namespace knuckle
