#pragma once

#include <string>

namespace knuckle {

/// The number of threads of a software driver that a run may choose, and the cost of waking them.
std::string threadsText();

}  // namespace knuckle
