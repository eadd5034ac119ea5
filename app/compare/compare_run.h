#pragma once

#include <string>
#include <vector>

#include "app/compare/limits_file.h"
#include "app/json/json.h"
#include "render/compare/verdict.h"

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
};

/// Two images, compared and judged.
struct ComparedImages {
    PictureComparison comparison;
    Verdict verdict;
    std::string differencePng, heatmapPng;  ///< As far as asked for, where sizes are the same.
};

/// Reads, compares and judges. @param name by which limits are looked up. @throws InputError.
ComparedImages compareImageFiles(const CompareRun& run, const std::string& first, const std::string& second,
                                 const std::string& name, unsigned threads);

/// All figures of a comparison.
Json comparisonToJson(const ComparedImages& images, const CompareSettings& settings);

/// Both print to standard output. @returns an exit code. @throws InputError.
int compareTwoImages(const CompareRun& run);
int compareFolders(const CompareRun& run);

}  // namespace knuckle
