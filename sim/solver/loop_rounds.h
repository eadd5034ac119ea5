#pragma once

#include <fmt/format.h>

#include "sim/base/errors.h"
#include "sim/gpu/gpu.h"

namespace knuckle {

/// @param rounds that one thread of a kernel runs through, of all its loops together. @param what has so many: "a rope
/// of 30000 particles". @throws DeviceError where the driver would leave the loops before.
inline void checkLoopRounds(const Gpu& gpu, uint64_t rounds, const std::string& what)
{
    if (rounds > gpu.limits().loopRounds)
        throw DeviceError(fmt::format("{}: {} takes {} rounds of loops in one thread and the driver allows {}; make it "
                                      "shorter, or use another --device",
                                      gpu.device().name, what, rounds, gpu.limits().loopRounds));
}

}  // namespace knuckle
