#pragma once

#include <cstdint>

namespace knuckle {

/// "Belongs to nothing", for every index.
inline constexpr uint32_t NO_INDEX = 0xffffffffu;

}  // namespace knuckle
