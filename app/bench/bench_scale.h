#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/run/open_gpu.h"

namespace knuckle {

struct ScaleOptions {
    std::vector<std::string> worlds = {"pairs", "dam", "sand"};
    std::vector<uint32_t> particles = {16000, 32000, 64000, 128000, 256000};  ///< The nearest that a world can have.
    uint32_t settling = 40, steps = 20;                                       ///< Not timed, and timed.
    bool json = false;
};

/// `bench scale`: how long a step takes, and how much memory, at growing numbers of particles. @returns the exit code.
int benchScale(const ScaleOptions& options, const CommonOptions& common);

}  // namespace knuckle
