#pragma once

#include "shared/step_parameters.h"
#include "sim/gpu/buffer_table.h"

namespace knuckle {

/// Contents of all buffers that are state; and the parameters, which say how much room their lists have.
struct StagesState {
    gpu::StepParameters parameters{};
    BufferState buffers;
};

}  // namespace knuckle
