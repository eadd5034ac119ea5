#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "app/export/exporters.h"
#include "app/states/run_state.h"
#include "sim/solver/measure/view_state.h"

namespace knuckle {

/// What was read back of a frame: the least from which its exports and recordings can be written.
struct FrameRecord {
    uint64_t number = 1;
    std::optional<ViewState> view = {};
    std::optional<std::vector<BodyState>> bodies = {};
    std::optional<Measures> measures = {};
    std::optional<RunState> state = {};
};

/// Hands a frame to exporters. The record must have what they need.
void exportFrame(const FrameRecord& record, const World& world, const ExportNeeds& needs, const Exporters& exporters);

}  // namespace knuckle
