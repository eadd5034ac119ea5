#pragma once

#include "app/report/report_entry.h"
#include "sim/base/files/output_file.h"

namespace knuckle {

/// Names and values as an HTML list; nothing for none.
std::string noteList(const std::vector<ReportNote>& notes, const char* kind);

/// An entry as a row of the report's table: name and verdict, four pictures, figures and places.
/// @param number from 1. @throws RunError as OutputFile.
void writeRow(OutputFile& file, const ReportEntry& entry, size_t number);

}  // namespace knuckle
