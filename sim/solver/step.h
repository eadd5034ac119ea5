#pragma once

#include "sim/solver/stages.h"

namespace knuckle {

/// Once, before the first step.
void recordStart(Stages& stages, Recorder& recorder);

/// Records one Settings::timeStep: the order of stages, by impulses or as the paper has it.
void recordStep(const Stages& stages, const Settings& settings, Recorder& recorder);

}  // namespace knuckle
