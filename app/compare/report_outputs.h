#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/files/run_paths.h"
#include "app/report/entry_list.h"
#include "app/report/report_page.h"
#include "sim/base/files/output_file.h"

namespace knuckle {

/// How large reports become where nothing else is said.
constexpr double DEFAULT_REPORT_MEGABYTES = 100.0;

/// Options --report, --junit and --annotations.
struct ReportOptions {
    std::string report = {}, junit = {};         ///< Files; empty: none.
    bool reportAll = false;                      ///< Equal images have pictures in the report, too.
    std::optional<double> reportMegabytes = {};  ///< Beyond it pictures are left out.
    bool annotations = false;                    ///< For GitHub, on standard output.

    /// Whether the report shows an entry.
    bool shows(const ReportEntry& entry) const { return !report.empty() && (reportAll || entry.failed()); }
};

/// What is written of all images together: --report, --junit and --annotations.
class ReportOutputs {
public:
    /// Adds all files that the options name to `paths`. @throws InputError for another ending.
    ReportOutputs(ReportOptions options, RunPaths& paths);
    /// Opens the files, before any work. @throws InputError.
    void open();
    /// Threads may add at the same time.
    void add(ReportEntry entry) { list_.add(std::move(entry)); }
    /// Writes what was asked for. @param suite the name of JUnit's. @returns all entries, sorted. @throws RunError.
    std::vector<ReportEntry> finish(const ReportHead& head, const std::string& suite);

private:
    void writePage(const ReportHead& head, const std::vector<ReportEntry>& entries);

    ReportOptions options_;
    EntryList list_;
    std::optional<OutputFile> report_, junit_;
};

}  // namespace knuckle
