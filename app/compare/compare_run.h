#pragma once

#include <string>
#include <vector>

#include "app/compare/limits_file.h"
#include "app/compare/report_outputs.h"
#include "app/json/json.h"
#include "app/report/report_entry.h"

namespace knuckle {

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
    ReportOptions reports;
};

/// What is told and shown of two images.
struct PictureWork {
    CompareSettings settings = {};
    CompareLimits limits = {};
    bool difference = false, heatmap = false;  ///< Wanted whatever the report shows.
};

/// Compares and judges an entry's two pictures. Fills in all but names and paths, with pictures as far as they are
/// wanted. @throws InputError for a mask of another size.
void judgePictures(ReportEntry& entry, const Picture& reference, const Picture& output, const PictureWork& work,
                   const ReportOptions& reports);

/// The title of a report, and JUnit's suite, of what was compared.
ReportHead headOf(const CompareRun& run);
std::string suiteOf(const CompareRun& run);

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
