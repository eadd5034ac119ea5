#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "app/states/run_state.h"
#include "sim/solver/measure/view_state.h"

namespace knuckle {

/// What was read back of a frame: the least from which its exports and recordings can be written.
struct FrameRecord {
    uint64_t number = 1;
    std::optional<ViewState> view = {};
    std::optional<std::vector<BodyState>> bodies = {};
    std::optional<Measures> measures = {};
    std::optional<std::vector<float>> densities = {};  ///< As Solver::fluidDensities().
    std::optional<RunState> state = {};
};

}  // namespace knuckle
