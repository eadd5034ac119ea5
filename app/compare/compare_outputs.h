#pragma once

#include <optional>

#include "app/compare/compare_run.h"
#include "app/files/run_paths.h"
#include "app/report/entry_list.h"
#include "sim/base/files/output_file.h"

namespace knuckle {

/// What is written of all images together: --report, --junit and --annotations.
class CompareOutputs {
public:
    /// Adds all files that `run` names to `paths`. @throws InputError for another ending.
    CompareOutputs(const CompareRun& run, RunPaths& paths);
    /// Checks `paths`, which must have all, and opens the files. @throws InputError.
    void open();
    /// Threads may add at the same time.
    void add(ReportEntry entry) { list_.add(std::move(entry)); }
    /// Writes what was asked for. @returns all entries, sorted. @throws RunError.
    std::vector<ReportEntry> finish();

private:
    void writePage(const std::vector<ReportEntry>& entries);

    const CompareRun& run_;
    RunPaths& paths_;
    EntryList list_;
    std::optional<OutputFile> report_, junit_;
};

}  // namespace knuckle
