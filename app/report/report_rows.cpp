#include "app/report/report_rows.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/report/markup.h"
#include "sim/base/base64.h"

namespace knuckle {

namespace {

using Status = ReportEntry::Status;

/// A cell with a picture, or an empty one.
void writePicture(OutputFile& file, const ReportEntry& entry, const char* kind, const std::string& png)
{
    file.write(fmt::format("<td class=\"picture\" data-label=\"{}\">", kind));
    if (!png.empty()) {
        file.write(fmt::format("<img class=\"{0}\" loading=\"lazy\" alt=\"{0} of {1}\" src=\"data:image/png;base64,",
                               kind, escapedMarkup(entry.name)));
        file.write(toBase64(png));
        file.write("\">");
    }
    file.write("</td>\n");
}

std::string placeList(const PictureComparison& comparison)
{
    if (comparison.places.empty()) return "";
    std::string list = "<ol class=\"places\">\n";
    for (size_t i = 0; i < std::min(MOST_LISTED_PLACES, comparison.places.size()); ++i) {
        const auto& [box, pixels] = comparison.places[i];
        list += fmt::format("<li data-box=\"{} {} {} {}\">{}: {} pixel{}</li>\n", box.x, box.y, box.width, box.height,
                            boxWords(box), pixels, pixels == 1 ? "" : "s");
    }
    list += "</ol>\n";
    if (const size_t others = comparison.places.size() - std::min(MOST_LISTED_PLACES, comparison.places.size()))
        list += fmt::format("<p>and {} other places</p>\n", others);
    return list;
}

/// Why there are no pictures; empty where there are.
std::string emptyWords(const ReportEntry& entry)
{
    if (entry.pictures.bytes() > 0) return "";
    if (entry.leftOutBytes > 0) return "no pictures: the report would be too large";
    return entry.status == ReportEntry::Status::Equal ? "no pictures: equal" : "no pictures";
}

}  // namespace

std::string noteList(const std::vector<ReportNote>& notes, const char* kind)
{
    if (notes.empty()) return "";
    std::string list = fmt::format("<dl class=\"{}\">\n", kind);
    for (const auto& [name, value] : notes)
        list += fmt::format("<div><dt>{}</dt><dd><bdi>{}</bdi></dd></div>\n", escapedMarkup(name),
                            escapedMarkup(value));
    return list + "</dl>\n";
}

void writeRow(OutputFile& file, const ReportEntry& entry, size_t number)
{
    file.write(fmt::format("<tr id=\"image-{}\" data-status=\"{}\" data-failed=\"{}\">\n", number, entry.statusWord(),
                           entry.failed() ? 1 : 0));
    file.write(
        fmt::format("<th scope=\"row\"><bdi class=\"name\">{}</bdi>\n<p class=\"line\"><bdi>{}</bdi></p>\n{}</th>\n",
                    escapedMarkup(entry.name), escapedMarkup(entry.line), noteList(entry.notes, "notes")));
    if (const std::string words = emptyWords(entry); !words.empty()) {
        file.write(fmt::format("<td class=\"none\" colspan=\"4\">{}</td>\n", words));
    } else {
        writePicture(file, entry, "reference", entry.pictures.reference);
        writePicture(file, entry, "output", entry.pictures.output);
        writePicture(file, entry, "difference", entry.pictures.difference);
        writePicture(file, entry, "heatmap", entry.pictures.heatmap);
    }
    const bool compared = entry.status == Status::Different || entry.status == Status::Equal;
    file.write(fmt::format("<td class=\"all\">{}{}</td>\n</tr>\n",
                           compared ? noteList(figuresOf(entry.comparison), "figures") : "",
                           compared ? placeList(entry.comparison) : ""));
}

}  // namespace knuckle
