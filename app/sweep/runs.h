#pragma once

#include <string>
#include <vector>

#include "app/sweep/plan.h"

namespace knuckle {

/// One run of a sweep.
struct SweepRun {
    uint64_t number = 1;       ///< As in run_0001.
    std::vector<Json> values;  ///< As SweepPlan::fields.
    std::string frames;        ///< As of --frames; empty: all.
};

/// All runs, those of one combination after each other. @throws InputError for states that cannot be read or divided.
std::vector<SweepRun> runsOf(const SweepPlan& plan);

/// Reads the scene with every value of every field, and the first run's whole. @throws InputError for a field that is
/// not there, a value out of its range, a body without that name.
void checkScene(const SweepPlan& plan, const std::vector<SweepRun>& runs);

/// What runs depend on: the plan and the contents of what it names. Two sweeps with the same one have the same runs.
std::string sweepFingerprint(const SweepPlan& plan);

}  // namespace knuckle
