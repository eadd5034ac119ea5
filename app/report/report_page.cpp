#include "app/report/report_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <string_view>

#include "app/report/markup.h"
#include "app/report/page_places.h"
#include "app/report/report_rows.h"
#include "render/compare/difference_pictures.h"

namespace knuckle {

/// Made by cmake/embed.cmake of assets/report.
const std::map<std::string, std::string_view>& embeddedReport();

namespace {

/// The colours of the heat map from left to right.
std::string heatGradient()
{
    std::string colors;
    for (const auto& [red, green, blue] : heatColors())
        colors += fmt::format("{}rgb({:.0f} {:.0f} {:.0f})", colors.empty() ? "" : ", ", red, green, blue);
    return "linear-gradient(to right, " + colors + ")";
}

/// What the report lacks, and why.
std::string leftOutWords(const std::vector<ReportEntry>& entries)
{
    size_t count = 0, bytes = 0;
    for (const ReportEntry& entry : entries) {
        count += entry.leftOutBytes > 0 ? 1 : 0;
        bytes += entry.leftOutBytes;
    }
    if (count == 0) return "";
    const std::string images = count == 1 ? "the last image that has any"
                                          : fmt::format("the last {} images that have any", count);
    return fmt::format("<p class=\"left-out\">Pictures of {} are left out: the report would have {:.0f} MB more.</p>\n",
                       images, std::ceil(static_cast<double>(bytes) / static_cast<double>(pictureBytesOf(1.0))));
}

}  // namespace

size_t pictureBytesOf(double megabytes)
{
    return static_cast<size_t>(megabytes * 1e6 * 3 / 4);
}

void writeReport(OutputFile& file, const ReportHead& head, const std::vector<ReportEntry>& entries)
{
    const auto text = [&file](const std::string& value) { return [&file, value] { file.write(value); }; };
    const auto part = [](const char* name) { return std::string(embeddedReport().at(name)); };
    const bool failed = std::ranges::any_of(entries, [](const ReportEntry& entry) { return entry.failed(); });
    const auto rows = [&] {
        for (size_t i = 0; i < entries.size(); ++i) writeRow(file, entries[i], i + 1);
    };
    fillPage(embeddedReport().at("report.html"),
             {{"title", text(escapedMarkup(head.title))},
              {"style", text(part("report.css"))},
              {"script", text(part("images.js") + part("stage.js") + part("viewer.js"))},
              {"verdict", text(failed ? "failed" : "passed")},
              {"summary", text(escapedMarkup(summaryOf(entries)))},
              {"notes", text(noteList(head.notes, "notes"))},
              {"left out", text(leftOutWords(entries))},
              {"heat", text(heatGradient())},
              {"gain", text(fmt::format("{:g}", DIFFERENCE_GAIN))},
              {"rows", rows}},
             [&file](std::string_view words) { file.write(words); });
}

void writeReport(const std::string& path, const ReportHead& head, const std::vector<ReportEntry>& entries)
{
    OutputFile file(path);
    writeReport(file, head, entries);
    file.commit();
}

}  // namespace knuckle
