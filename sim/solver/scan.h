#pragma once

#include "shared/constants.h"
#include "sim/gpu/buffer.h"

namespace knuckle {

/// What the kernel scan_sum needs for the prefix sum of some values: a sum for each chunk of SCAN_CHUNK of them, and
/// behind them how many of its work groups have finished, which it sets back to 0.
inline Buffer<uint32_t> scanSums(const char* name, uint64_t values)
{
    Buffer<uint32_t> sums(name, (values + SCAN_CHUNK - 1) / SCAN_CHUNK + 1);
    sums.clear();
    return sums;
}

}  // namespace knuckle
