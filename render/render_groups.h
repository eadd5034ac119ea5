#pragma once

#include <cstddef>
#include <cstdint>

#include "shared/frame_types.h"

namespace knuckle {

/// Work groups for as many threads of a renderer's kernel.
inline uint32_t renderGroups(size_t threads)
{
    return static_cast<uint32_t>((threads + RENDER_GROUP_SIZE - 1) / RENDER_GROUP_SIZE);
}

}  // namespace knuckle
