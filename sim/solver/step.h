#pragma once

#include "sim/solver/stages.h"

namespace knuckle {

/// Once, before the first step.
void recordStart(Stages& stages, Recorder& recorder);

/// Records one Settings::timeStep: the stages in the order of the default solver or of the paper's.
void recordStep(const Stages& stages, const Settings& settings, Recorder& recorder);

}  // namespace knuckle
