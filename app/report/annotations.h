#pragma once

#include "app/report/report_entry.h"

namespace knuckle {

/// A line for each image that failed, by which GitHub's workflows mark a file: the reference, or the output where there
/// is none.
std::string githubAnnotations(const std::vector<ReportEntry>& entries);

}  // namespace knuckle
