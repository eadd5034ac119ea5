#pragma once

#include <string>

#include "app/states/states_file.h"

namespace knuckle {

/// What is in a file of states, for `knuckle info FILE`.
std::string statesText(const StatesFile& states);

}  // namespace knuckle
