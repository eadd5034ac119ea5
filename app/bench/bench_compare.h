#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/bench/speed_ratio.h"
#include "app/run/open_gpu.h"

namespace knuckle {

struct CompareProgramsOptions {
    std::string a, b;                 ///< Paths of two knuckle programs.
    std::vector<std::string> trials;  ///< Names; none: those that are run by default.
    uint32_t rounds = 9;
    bool json = false;
};

/// "B is 3.9 % faster (95 %: 1.2 .. 6.3)", or "no difference seen (95 %: -1.0 .. 2.3 % faster)".
std::string verdictOf(const SpeedRatio& ratio);

/// `bench compare`: runs both in turn, B first in every second round, and prints how fast B is beside A.
/// @returns the exit code. @throws InputError for what is no program, RunError for one that fails.
int benchCompare(const CompareProgramsOptions& options, const CommonOptions& common);

}  // namespace knuckle
