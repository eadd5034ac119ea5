#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>

#include "app/compare/compare_run.h"
#include "app/files/run_paths.h"
#include "app/report/report_pictures.h"
#include "app/run/exit_codes.h"
#include "app/states/picture_labels.h"
#include "render/compare/difference_pictures.h"
#include "render/reader/picture_file.h"
#include "sim/base/errors.h"
#include "sim/base/files/endings.h"
#include "sim/base/files/output_file.h"

namespace knuckle {

namespace {

constexpr const char* ORIGINS = "the pictures are";

Json boxToJson(const PixelBox& box)
{
    return {{"x", box.x}, {"y", box.y}, {"width", box.width}, {"height", box.height}};
}

Json differencesToJson(const PictureComparison& comparison)
{
    const Differences& differences = comparison.differences;
    const auto compared = static_cast<double>(std::max<uint64_t>(1, comparison.compared));
    Json json = {{"differing", differences.differing},
                 {"changed", differences.changed},
                 {"share", static_cast<double>(differences.changed) / compared},
                 {"antialiased", comparison.antialiased},
                 {"mean", differences.mean},
                 {"largest", differences.max}};
    const std::array<const char*, 4> names{"red", "green", "blue", "alpha"};
    for (size_t c = 0; c < names.size(); ++c)
        json["channels"][names[c]] = {{"mean", differences.channels[c].mean}, {"largest", differences.channels[c].max}};
    return json;
}

Json placesToJson(const PictureComparison& comparison)
{
    Json places = Json::array();
    for (size_t i = 0; i < std::min(MOST_LISTED_PLACES, comparison.places.size()); ++i) {
        Json place = boxToJson(comparison.places[i].box);
        place["pixels"] = comparison.places[i].pixels;
        places.push_back(std::move(place));
    }
    return places;
}

/// A picture that is written when the comparison is done; tried before.
class PictureOutput {
public:
    PictureOutput(const std::string& option, const std::string& path, RunPaths& paths) : path_(path)
    {
        if (path.empty()) return;
        requireEnding(option, path, "a picture", {".png"});
        paths.writes(path);
    }
    void open()
    {
        if (!path_.empty()) file_.emplace(path_);
    }
    void finish(const std::string& png)
    {
        if (!file_ || png.empty()) return;
        file_->write(png);
        file_->commit();
    }

private:
    std::string path_;
    std::optional<OutputFile> file_;
};

/// Where a difference is, and where the pictures come from.
std::vector<std::string> moreLines(const ReportEntry& entry)
{
    std::vector<std::string> lines;
    const std::string places = entry.verdict.equal ? "" : placesLine(entry.comparison);
    if (!places.empty()) lines.push_back(places);
    for (const auto& [name, value] : entry.notes)
        if (name == ORIGINS) lines.push_back("they are " + value);
    return lines;
}

/// Reads, compares and judges the entry's files. @throws InputError.
void compareFiles(const CompareRun& run, ReportEntry& entry, unsigned threads)
{
    PictureWork work{run.settings, {}, !run.difference.empty(), !run.heatmap.empty()};
    work.settings.threads = threads;
    run.file.applyTo(entry.name, work.settings.threshold, work.limits);
    run.given.applyTo(work.settings.threshold, work.limits);
    std::string firstBytes = readPictureBytes(entry.referencePath);
    const std::string secondBytes = readPictureBytes(entry.outputPath);
    const bool same = firstBytes == secondBytes;
    const Picture a = decodePicture(firstBytes, entry.referencePath);
    std::string().swap(firstBytes);
    const std::optional<Picture> other = same ? std::nullopt
                                              : std::optional(decodePicture(secondBytes, entry.outputPath));
    judgePictures(entry, a, other ? *other : a, work, run.reports);
}

}  // namespace

void judgePictures(ReportEntry& entry, const Picture& reference, const Picture& output, const PictureWork& work,
                   const ReportOptions& reports)
{
    PictureComparison& comparison = entry.comparison;
    comparison = &reference == &output ? identicalPictures(reference, work.settings)
                                       : comparePictures(reference, output, work.settings);
    entry.verdict = judge(comparison, work.limits);
    entry.status = entry.verdict.equal ? ReportEntry::Status::Equal : ReportEntry::Status::Different;
    const std::string origins = entry.verdict.equal ? "" : originsLine(reference.text, output.text);
    if (!origins.empty()) entry.notes.emplace_back(ORIGINS, origins);
    entry.line = verdictLine(comparison, entry.verdict);
    for (const std::string& more : moreLines(entry)) entry.line += "; " + more;
    const bool reported = reports.shows(entry);
    if (reported) {
        entry.pictures.reference = shownPng(reference);
        entry.pictures.output = shownPng(output);
    }
    if (comparison.sameSize()) {
        if (reported || work.difference)
            entry.pictures.difference = pngOf(differencePicture(reference, output, comparison));
        if (reported || work.heatmap) entry.pictures.heatmap = pngOf(heatmapPicture(comparison));
    }
    // Figures of single pixels are large, and there may be thousands of images. Not = {}, which keeps the memory.
    comparison.differences.marks = std::vector<uint8_t>();
    comparison.flip.errors = std::vector<float>();
}

ReportHead headOf(const CompareRun& run)
{
    return {fmt::format("{} and {}", run.first, run.second),
            {{"reference", run.first}, {"output", run.second}, {"made by", "knuckle " KNUCKLE_VERSION}}};
}

std::string suiteOf(const CompareRun& run)
{
    return fmt::format("knuckle compare {} {}", run.first, run.second);
}

ReportEntry compareImageFiles(const CompareRun& run, const std::string& first, const std::string& second,
                              const std::string& name, unsigned threads)
{
    ReportEntry entry;
    entry.name = name;
    entry.referencePath = first;
    entry.outputPath = second;
    try {
        compareFiles(run, entry, threads);
    } catch (const InputError& error) {
        entry.status = ReportEntry::Status::Unreadable;
        entry.line = error.what();
        if (!run.reports.report.empty()) readPictures(entry);
    }
    return entry;
}

Json comparisonToJson(const ReportEntry& entry, const CompareSettings& settings)
{
    const PictureComparison& comparison = entry.comparison;
    Json json = {{"verdict", entry.verdict.word()},
                 {"reasons", entry.verdict.reasons},
                 {"width", comparison.width},
                 {"height", comparison.height}};
    if (!comparison.sameSize()) {
        json["secondWidth"] = comparison.secondWidth;
        json["secondHeight"] = comparison.secondHeight;
        return json;
    }
    json["compared"] = comparison.compared;
    json["threshold"] = comparison.threshold;
    json.update(differencesToJson(comparison));
    json["tile"] = boxToJson(comparison.tile.box);
    json["tile"]["score"] = comparison.tile.score;
    json["flip"] = {{"kind", comparison.hdr ? "HDR" : "LDR"},
                    {"pixelsPerDegree", settings.flip.pixelsPerDegree},
                    {"mean", comparison.flip.mean},
                    {"largest", comparison.flip.max}};
    json["ssim"] = {{"mean", comparison.ssim.mean}, {"worst", comparison.ssim.worst}};
    json["ssim"]["window"] = boxToJson(comparison.ssim.box);
    json["placeCount"] = comparison.places.size();
    json["places"] = placesToJson(comparison);
    return json;
}

int compareTwoImages(const CompareRun& run)
{
    RunPaths paths;
    paths.reads(run.first);
    paths.reads(run.second);
    PictureOutput difference("--difference ", run.difference, paths), heatmap("--heatmap ", run.heatmap, paths);
    for (const std::string& input : run.otherInputs) paths.reads(input);
    ReportOutputs outputs(run.reports, paths);
    paths.check();
    difference.open();
    heatmap.open();
    outputs.open();
    const std::string name = std::filesystem::path(run.first).filename().string();
    ReportEntry entry = compareImageFiles(run, run.first, run.second, name, run.settings.threads);
    const bool readable = entry.status != ReportEntry::Status::Unreadable;
    if (readable) {
        difference.finish(entry.pictures.difference);
        heatmap.finish(entry.pictures.heatmap);
    }
    if (readable && run.json) {
        Json json = {{"first", run.first}, {"second", run.second}};
        json.update(comparisonToJson(entry, run.settings));
        fmt::print("{}\n", json.dump(2, ' ', false, Json::error_handler_t::replace));
    } else if (readable && !run.quiet) {
        fmt::print("{}\n", verdictLine(entry.comparison, entry.verdict));
        for (const std::string& more : moreLines(entry)) fmt::print("{}\n", more);
    }
    const std::string line = entry.line;
    outputs.add(std::move(entry));
    const std::vector<ReportEntry> entries = outputs.finish(headOf(run), suiteOf(run));
    if (!readable) throw InputError(line);
    return entries.front().verdict.equal ? EXIT_FINE : EXIT_DIFFERENT;
}

}  // namespace knuckle
