#pragma once

#include <cstdint>
#include <vector>

#include "app/sweep/plan.h"

namespace knuckle {

bool isWhole(double number);

/// A range's values, evenly from end to end. @param count at least 2.
std::vector<Json> evenValues(const SweepField& field, uint64_t count);

/// How many combinations of values the plan has, or runs at random; MAX_RUNS + 1 if there are more.
uint64_t combinationCount(const SweepPlan& plan);

/// The values of the plan's fields, in their order, of each run. Made of sums and products that are rounded in the same
/// way on all machines.
std::vector<std::vector<Json>> sampleFields(const SweepPlan& plan);

}  // namespace knuckle
