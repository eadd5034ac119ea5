#include "app/report/report_entry.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace knuckle {

using Status = ReportEntry::Status;

const char* ReportEntry::statusWord() const
{
    constexpr std::array<const char*, 5> WORDS{"different", "unreadable", "missing", "new", "equal"};
    return WORDS.at(static_cast<size_t>(status));
}

bool isWorse(const ReportEntry& p, const ReportEntry& q)
{
    const PictureComparison &a = p.comparison, &b = q.comparison;
    if (p.status != q.status) return p.status < q.status;
    if (a.sameSize() != b.sameSize()) return b.sameSize();
    if (a.tile.score != b.tile.score) return a.tile.score > b.tile.score;
    if (a.flip.mean != b.flip.mean) return a.flip.mean > b.flip.mean;
    return p.name < q.name;
}

std::string summaryOf(const std::vector<ReportEntry>& entries)
{
    const auto count = [&](Status status) {
        return std::ranges::count_if(entries, [&](const ReportEntry& entry) { return entry.status == status; });
    };
    const auto different = count(Status::Different), missing = count(Status::Missing), added = count(Status::New),
               unreadable = count(Status::Unreadable);
    const bool allowed = std::ranges::any_of(entries, [](const ReportEntry& entry) { return entry.allowed; });
    std::string text = fmt::format("{} of {} images {}", different, different + unreadable + count(Status::Equal),
                                   different == 1 ? "differs" : "differ");
    if (missing > 0) text += fmt::format(", {} missing", missing);
    if (added > 0) text += fmt::format(", {} new{}", added, allowed ? " (allowed)" : "");
    if (unreadable > 0) text += fmt::format(", {} cannot be read", unreadable);
    return text;
}

std::vector<ReportNote> figuresOf(const PictureComparison& comparison)
{
    std::vector<ReportNote> figures{{"size", fmt::format("{} x {}", comparison.width, comparison.height)}};
    if (!comparison.sameSize()) {
        figures.emplace_back("size of the output",
                             fmt::format("{} x {}", comparison.secondWidth, comparison.secondHeight));
        return figures;
    }
    const Differences& differences = comparison.differences;
    const auto compared = static_cast<double>(std::max<uint64_t>(1, comparison.compared));
    figures.emplace_back("compared pixels", std::to_string(comparison.compared));
    figures.emplace_back("differing pixels", std::to_string(differences.differing));
    figures.emplace_back("changed pixels", std::to_string(differences.changed));
    figures.emplace_back("changed share", shortNumber(static_cast<double>(differences.changed) / compared));
    figures.emplace_back("threshold", shortNumber(static_cast<double>(comparison.threshold)));
    if (comparison.antialiased > 0)
        figures.emplace_back("ignored pixels of edges", std::to_string(comparison.antialiased));
    figures.emplace_back("mean", shortNumber(differences.mean));
    figures.emplace_back("largest", shortNumber(differences.max));
    const std::array<const char*, 4> names{"red", "green", "blue", "alpha"};
    for (size_t c = 0; c < names.size(); ++c)
        figures.emplace_back(names[c], fmt::format("mean {}, largest {}", shortNumber(differences.channels[c].mean),
                                                   shortNumber(differences.channels[c].max)));
    const TileDifference& tile = comparison.tile;
    figures.emplace_back("worst tile", tile.score > 0.0 ? shortNumber(tile.score) + " " + boxWords(tile.box) : "0");
    figures.emplace_back(
        comparison.hdr ? "HDR-FLIP" : "FLIP",
        fmt::format("mean {}, largest {}", shortNumber(comparison.flip.mean), shortNumber(comparison.flip.max)));
    figures.emplace_back("SSIM", fmt::format("mean {}, worst {}", shortNumber(comparison.ssim.mean),
                                             shortNumber(comparison.ssim.worst)));
    figures.emplace_back("places", std::to_string(comparison.places.size()));
    return figures;
}

}  // namespace knuckle
