#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "shared/step_parameters.h"

namespace knuckle {

/// What all buffers hold that are added as Lifetime::State, by their names; and the parameters, which say how much room
/// their lists have.
struct StagesState {
    gpu::StepParameters parameters{};
    std::map<std::string, std::vector<std::byte>> buffers;
};

}  // namespace knuckle
