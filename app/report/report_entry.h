#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "render/compare/verdict.h"

namespace knuckle {

/// PNG files of a compared image; empty: there is none.
struct ReportPictures {
    std::string reference, output;
    std::string difference, heatmap;  ///< See difference_pictures.h.

    size_t bytes() const { return reference.size() + output.size() + difference.size() + heatmap.size(); }
    /// Frees their memory, which strings keep where an empty one is assigned.
    void drop() { const ReportPictures dropped = std::exchange(*this, {}); }
};

/// What is told beside an image or a report: a name and its value, such as "driver of the reference".
using ReportNote = std::pair<std::string, std::string>;

/// One image of a report: an HTML page, JUnit's XML or annotations.
struct ReportEntry {
    /// The order of the report.
    enum class Status : uint8_t { Different, Unreadable, Missing, New, Equal };

    std::string name;  ///< As a person knows it, perhaps a path with slashes; any bytes.
    Status status = Status::Equal;
    bool allowed = false;  ///< A `New` one that is no failure.
    std::string line;      ///< The verdict in words.
    Verdict verdict;       ///< Of `Different` and `Equal` ones, as `comparison`.
    PictureComparison comparison;
    std::string referencePath, outputPath;  ///< Of the compared files; empty: there is none.
    ReportPictures pictures;
    size_t leftOutBytes = 0;        ///< Of pictures that were left out since the report would be too large.
    std::vector<ReportNote> notes;  ///< Told with it, in this order.

    bool failed() const { return status != Status::Equal && !allowed; }
    /// "different", "unreadable", "missing", "new", "equal".
    const char* statusWord() const;
};

/// Whether `p` stands before `q`: by status, of different ones other sizes first, then the worst tile and the mean of
/// FLIP. Names decide where those are equal.
bool isWorse(const ReportEntry& p, const ReportEntry& q);

/// "3 of 4 images differ, 1 missing, 1 new"; missing and new ones were not compared.
std::string summaryOf(const std::vector<ReportEntry>& entries);

/// All figures of a comparison by the names of docs/compare.md; of another size only sizes.
std::vector<ReportNote> figuresOf(const PictureComparison& comparison);

}  // namespace knuckle
