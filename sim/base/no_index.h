#pragma once

#include <cstdint>

namespace knuckle {

/// "Belongs to nothing", for any kind of index.
inline constexpr uint32_t NO_INDEX = 0xffffffffu;

}  // namespace knuckle
