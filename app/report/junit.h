#pragma once

#include "app/report/report_entry.h"

namespace knuckle {

/// JUnit's XML: a suite with a case for each image, in which what failed has its verdict, what cannot be read an error,
/// and figures and notes are properties. Without times, so that equal images give equal bytes.
/// @param suite its name; any bytes.
std::string junitOf(const std::string& suite, const std::vector<ReportEntry>& entries);

}  // namespace knuckle
