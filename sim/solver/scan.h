#pragma once

#include "shared/constants.h"
#include "sim/gpu/buffer.h"

namespace knuckle {

/// Buffer of the kernel scan_sum for the prefix sum of some values: a sum for each chunk of SCAN_CHUNK values, then the
/// number of its work groups that have finished, which the kernel resets to 0.
inline Buffer<uint32_t> scanSums(const char* name, uint64_t values)
{
    Buffer<uint32_t> sums(name, (values + SCAN_CHUNK - 1) / SCAN_CHUNK + 1);
    sums.clear();
    return sums;
}

}  // namespace knuckle
