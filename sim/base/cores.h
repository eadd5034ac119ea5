#pragma once

#include <cstdint>

namespace knuckle {

/// Cores that this process may run on, at least 1.
uint32_t usableCores();

}  // namespace knuckle
