#pragma once

#include "app/report/report_entry.h"
#include "sim/base/files/output_file.h"

namespace knuckle {

/// What a report says of itself.
struct ReportHead {
    std::string title;              ///< In one line; any bytes.
    std::vector<ReportNote> notes;  ///< Such as what was compared, by which program and driver.
};

/// How many bytes of PNG files fit into a report of so many megabytes: they are written in base64.
size_t pictureBytesOf(double megabytes);

/// Writes one HTML page that needs nothing beside it: a table of all entries in their order, with pictures and figures,
/// which a script makes a viewer of. docs/compare.md.
/// @param entries as EntryList has them. @throws RunError as OutputFile.
void writeReport(OutputFile& file, const ReportHead& head, const std::vector<ReportEntry>& entries);
/// The same, from opening the file to giving it its name. @throws InputError as well.
void writeReport(const std::string& path, const ReportHead& head, const std::vector<ReportEntry>& entries);

}  // namespace knuckle
