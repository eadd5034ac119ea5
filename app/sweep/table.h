#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/sweep/run_result.h"

namespace knuckle {

/// A row of a run's number, values, hash and measures for each run. Nothing in it says where or when runs were done.
struct SweepTable {
    std::vector<std::string> columns;
    std::vector<std::vector<std::string>> rows;     ///< As Sweep::runs; what is not known is empty.
    std::vector<std::optional<RunResult>> results;  ///< The same; none: it is not done.

    size_t missing() const;
    /// On which runs were simulated.
    std::set<std::string> devices() const;
    std::string csv() const;
};

/// @throws InputError for results that are damaged.
SweepTable tableOf(const Sweep& sweep);

/// A page with what each run has drawn, by paths from the sweep's folder.
std::string sweepPage(const Sweep& sweep, const SweepTable& table);

}  // namespace knuckle
