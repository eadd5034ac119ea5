#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>

#include "app/compare/compare_run.h"
#include "app/files/run_paths.h"
#include "app/run/exit_codes.h"
#include "render/compare/difference_pictures.h"
#include "render/reader/picture_file.h"
#include "sim/base/files/endings.h"
#include "sim/base/files/output_file.h"

namespace knuckle {

namespace {

/// The largest places are listed, the others counted.
constexpr size_t MOST_PLACES = 100;

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
    for (size_t i = 0; i < std::min(MOST_PLACES, comparison.places.size()); ++i) {
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

}  // namespace

ComparedImages compareImageFiles(const CompareRun& run, const std::string& first, const std::string& second,
                                 const std::string& name, unsigned threads)
{
    CompareSettings settings = run.settings;
    settings.threads = threads;
    CompareLimits limits;
    run.file.applyTo(name, settings.threshold, limits);
    run.given.applyTo(settings.threshold, limits);
    ComparedImages images;
    std::string firstBytes = readPictureBytes(first);
    const std::string secondBytes = readPictureBytes(second);
    const bool same = firstBytes == secondBytes;
    const Picture a = decodePicture(firstBytes, first);
    firstBytes = {};
    const std::optional<Picture> other = same ? std::nullopt : std::optional(decodePicture(secondBytes, second));
    const Picture& b = other ? *other : a;
    images.comparison = same ? identicalPictures(a, settings) : comparePictures(a, b, settings);
    images.verdict = judge(images.comparison, limits);
    if (!images.comparison.sameSize()) return images;
    if (!run.difference.empty()) images.differencePng = pngOf(differencePicture(a, b, images.comparison));
    if (!run.heatmap.empty()) images.heatmapPng = pngOf(heatmapPicture(images.comparison));
    return images;
}

Json comparisonToJson(const ComparedImages& images, const CompareSettings& settings)
{
    const PictureComparison& comparison = images.comparison;
    Json json = {{"verdict", images.verdict.word()},
                 {"reasons", images.verdict.reasons},
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
    for (const std::string& input : run.otherInputs) paths.reads(input);
    PictureOutput difference("--difference ", run.difference, paths), heatmap("--heatmap ", run.heatmap, paths);
    paths.check();
    difference.open();
    heatmap.open();
    const std::string name = std::filesystem::path(run.first).filename().string();
    const ComparedImages images = compareImageFiles(run, run.first, run.second, name, run.settings.threads);
    difference.finish(images.differencePng);
    heatmap.finish(images.heatmapPng);
    if (run.json) {
        Json json = {{"first", run.first}, {"second", run.second}};
        json.update(comparisonToJson(images, run.settings));
        fmt::print("{}\n", json.dump(2, ' ', false, Json::error_handler_t::replace));
    } else if (!run.quiet) {
        fmt::print("{}\n", verdictLine(images.comparison, images.verdict));
        const std::string places = placesLine(images.comparison);
        if (!images.verdict.equal && !places.empty()) fmt::print("{}\n", places);
    }
    return images.verdict.equal ? EXIT_FINE : EXIT_DIFFERENT;
}

}  // namespace knuckle
