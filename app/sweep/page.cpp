#include <fmt/format.h>

#include <map>
#include <string_view>

#include "app/film/film_outputs.h"
#include "app/report/markup.h"
#include "app/report/page_places.h"
#include "app/run/counted.h"
#include "app/sweep/table.h"
#include "sim/base/files/endings.h"

namespace knuckle {

/// Made by cmake/embed.cmake of assets/sweep.
const std::map<std::string, std::string_view>& embeddedSweep();

namespace {

/// A path as an address: what has a meaning of its own there as %20.
std::string address(const std::string& path)
{
    std::string text;
    for (const char c : path) {
        const bool plain = std::isalnum(static_cast<unsigned char>(c)) != 0 ||
                           std::string_view("/._-").find(c) != std::string_view::npos;
        text += plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
    }
    return text;
}

/// A film that browsers play, a picture that they show, else a link.
std::string pictureMarkup(const std::string& path)
{
    const std::string link = address(path), ending = endingOf(path);
    if (ending == ".exr" || ending == ".mkv") return fmt::format("<a href=\"{}\">{}</a>", link, escapedMarkup(path));
    if (isFilm(path) && ending != ".gif" && ending != ".webp" && ending != ".apng")
        return fmt::format("<video src=\"{}\" controls loop muted playsinline preload=\"metadata\"></video>", link);
    return fmt::format("<a href=\"{0}\"><img src=\"{0}\" loading=\"lazy\" alt=\"\"></a>", link);
}

/// A number with as many digits as people read.
std::string shortened(const std::string& cell)
{
    const Json value = Json::parse(cell, nullptr, false);
    return value.is_number_float() ? fmt::format("{:.6g}", value.get<double>()) : cell;
}

std::string cardOf(const SweepRun& run, const SweepTable& table, size_t index)
{
    const std::string folder = runName(run.number);
    const std::optional<RunResult>& result = table.results[index];
    std::string text = fmt::format("<article{}>\n<h2><a href=\"{}/\">run {}</a></h2>\n",
                                   result ? "" : " class=\"missing\"", folder, run.number);
    text += result ? pictureMarkup(folder + "/" + result->picture)
                   : fmt::format("<p>not done: <a href=\"{}/log\">log</a></p>", folder);
    text += "\n<dl>\n";
    for (size_t k = 1; k < table.columns.size(); ++k)
        text += fmt::format("<div><dt>{}</dt><dd title=\"{}\">{}</dd></div>\n", escapedMarkup(table.columns[k]),
                            escapedMarkup(table.rows[index][k]), escapedMarkup(shortened(table.rows[index][k])));
    return text + "</dl>\n</article>\n";
}

}  // namespace

std::string sweepPage(const Sweep& sweep, const SweepTable& table)
{
    std::string cards, columns;
    for (size_t k = 0; k < sweep.runs.size(); ++k) cards += cardOf(sweep.runs[k], table, k);
    for (size_t k = 0; k < table.columns.size(); ++k)
        columns += fmt::format("<option value=\"{}\">{}</option>\n", k, escapedMarkup(table.columns[k]));
    const size_t done = sweep.runs.size() - table.missing();
    std::string summary = fmt::format("{} of {} done", done, counted(sweep.runs.size(), "run"));
    for (const std::string& device : table.devices()) summary += ", on " + device;
    return filledPage(embeddedSweep().at("sweep.html"), {{"title", escapedMarkup(sweep.plan.name)},
                                                         {"style", std::string(embeddedSweep().at("sweep.css"))},
                                                         {"script", std::string(embeddedSweep().at("sweep.js"))},
                                                         {"summary", escapedMarkup(summary)},
                                                         {"columns", columns},
                                                         {"cards", cards}});
}

}  // namespace knuckle
