#pragma once

#include <string>

#include "app/states/states_file.h"

namespace knuckle {

/// What is in a file of states, for `knuckle info FILE`.
std::string statesText(const StatesFile& states);

/// Frames in order: "1 to 600", "1, 61, 121", "none".
std::string framesText(const std::vector<uint64_t>& frames);

}  // namespace knuckle
