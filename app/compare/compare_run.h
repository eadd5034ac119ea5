#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/compare/limits_file.h"
#include "app/json/json.h"
#include "app/report/report_entry.h"

namespace knuckle {

/// How large reports become where nothing else is said.
constexpr double DEFAULT_REPORT_MEGABYTES = 100.0;

/// What `knuckle compare` was told.
struct CompareRun {
    std::string first, second;             ///< Two images, or two folders.
    std::vector<std::string> otherInputs;  ///< Files that no output may replace: a mask, limits.
    CompareSettings settings;
    LimitsFile file;
    GivenLimits given;                  ///< On the command line, which comes before the file.
    std::string difference, heatmap;    ///< PNG files, of folders folders; empty: none.
    std::vector<std::string> patterns;  ///< Of names in folders; empty: all that end as images do.
    bool allowNew = false, json = false, quiet = false;
    std::string report, junit;              ///< Files; empty: none.
    bool reportAll = false;                 ///< Equal images have pictures in the report, too.
    std::optional<double> reportMegabytes;  ///< Beyond it pictures are left out.
    bool annotations = false;               ///< For GitHub, on standard output.
};

/// Reads, compares and judges two images: `Different`, `Equal`, or `Unreadable` with what is wrong as its line.
/// Pictures are made as far as `run` asks for any.
/// @param name by which limits are looked up.
ReportEntry compareImageFiles(const CompareRun& run, const std::string& first, const std::string& second,
                              const std::string& name, unsigned threads);

/// All figures of an entry that was compared.
Json comparisonToJson(const ReportEntry& entry, const CompareSettings& settings);

/// Both print to standard output. @returns an exit code. @throws InputError.
int compareTwoImages(const CompareRun& run);
int compareFolders(const CompareRun& run);

}  // namespace knuckle
