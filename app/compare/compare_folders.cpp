#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "app/compare/compare_run.h"
#include "app/files/files_below.h"
#include "app/report/report_pictures.h"
#include "app/run/exit_codes.h"
#include "app/run/tell.h"
#include "render/compare/parallel.h"
#include "sim/base/cores.h"
#include "sim/base/errors.h"
#include "sim/base/files/endings.h"
#include "sim/base/files/output_file.h"
#include "sim/rig/anatomy/names/name_pattern.h"

namespace knuckle {

namespace {

namespace fs = std::filesystem;
using Status = ReportEntry::Status;

constexpr std::array<const char*, 4> IMAGE_ENDINGS{".png", ".jpg", ".jpeg", ".exr"};

bool isWanted(const std::string& name, const std::vector<std::string>& patterns)
{
    const std::string file = name.substr(name.rfind('/') + 1);
    if (patterns.empty()) return std::ranges::count(IMAGE_ENDINGS, endingOf(file)) > 0;
    return std::ranges::any_of(patterns, [&](const std::string& pattern) {
        return matchesPattern(name, pattern) || matchesPattern(file, pattern);
    });
}

/// The images below a folder, by their path in it.
std::set<std::string> imagesIn(const std::string& folder, const std::vector<std::string>& patterns)
{
    std::set<std::string> names = filesBelow(folder);
    std::erase_if(names, [&](const std::string& name) { return !isWanted(name, patterns); });
    return names;
}

struct FolderNames {
    std::vector<std::string> both, missing, added;
};

FolderNames namesOf(const CompareRun& run)
{
    const std::set<std::string> first = imagesIn(run.first, run.patterns), second = imagesIn(run.second, run.patterns);
    FolderNames names;
    std::ranges::set_intersection(first, second, std::back_inserter(names.both));
    std::ranges::set_difference(first, second, std::back_inserter(names.missing));
    std::ranges::set_difference(second, first, std::back_inserter(names.added));
    if (first.empty() && second.empty())
        throw InputError(fmt::format("no images in {} and {}{}", run.first, run.second,
                                     run.patterns.empty() ? "; PNG, JPEG and EXR are compared, by their endings"
                                                          : "; no name matches --pattern"));
    return names;
}

/// Where the picture of an image's difference goes.
void writeBeside(const std::string& folder, const std::string& name, const std::string& png)
{
    if (folder.empty() || png.empty()) return;
    writeFile((fs::path(folder) / fs::path(name).replace_extension(".png")).string(), png);
}

ReportEntry comparePair(const CompareRun& run, const std::string& name)
{
    ReportEntry entry = compareImageFiles(run, (fs::path(run.first) / name).string(),
                                          (fs::path(run.second) / name).string(), name, 1);
    if (entry.status == Status::Different) {
        writeBeside(run.difference, name, entry.pictures.difference);
        writeBeside(run.heatmap, name, entry.pictures.heatmap);
    }
    if (run.reports.report.empty()) entry.pictures.drop();
    return entry;
}

/// An image that only one of the folders has.
ReportEntry singleImage(const CompareRun& run, const std::string& name, ReportEntry::Status status)
{
    ReportEntry entry;
    entry.name = name;
    entry.status = status;
    if (status == Status::Missing) {
        entry.referencePath = (fs::path(run.first) / name).string();
        entry.line = "missing in " + run.second;
    } else {
        entry.outputPath = (fs::path(run.second) / name).string();
        entry.line = "new, not in " + run.first;
        entry.allowed = run.allowNew;
    }
    if (!run.reports.report.empty()) readPictures(entry);
    return entry;
}

/// Compares what both folders have, and looks at what only one has, one image on each core.
void compareAll(const CompareRun& run, const FolderNames& names, ReportOutputs& outputs)
{
    const size_t pairs = names.both.size(), known = pairs + names.missing.size();
    forEachParallel(known + names.added.size(), usableCores(), [&](size_t i) {
        if (i < pairs) outputs.add(comparePair(run, names.both[i]));
        else if (i < known) outputs.add(singleImage(run, names.missing[i - pairs], Status::Missing));
        else outputs.add(singleImage(run, names.added[i - known], Status::New));
    });
}

void printEntries(const std::vector<ReportEntry>& entries)
{
    for (const ReportEntry& entry : entries)
        if (entry.status != Status::Equal && entry.status != Status::Unreadable)
            fmt::print("{}: {}\n", entry.name, entry.line);
    fmt::print("{}\n", summaryOf(entries));
}

void printJson(const CompareRun& run, const FolderNames& names, const std::vector<ReportEntry>& entries, bool equal)
{
    Json json = {{"first", run.first},       {"second", run.second}, {"verdict", equal ? "equal" : "different"},
                 {"missing", names.missing}, {"new", names.added},   {"unreadable", Json::array()},
                 {"images", Json::array()}};
    for (const ReportEntry& entry : entries) {
        if (entry.status == Status::Missing || entry.status == Status::New) continue;
        Json image = {{"name", entry.name}};
        const bool readable = entry.status != Status::Unreadable;
        if (readable) image.update(comparisonToJson(entry, run.settings));
        else image["error"] = entry.line;
        json[readable ? "images" : "unreadable"].push_back(std::move(image));
    }
    fmt::print("{}\n", json.dump(2, ' ', false, Json::error_handler_t::replace));
}

/// An output in a folder of inputs would be compared the next time.
void checkOutput(const std::string& option, const std::string& folder, const CompareRun& run)
{
    if (folder.empty()) return;
    requireFolder(option, folder);
    const fs::path place = fs::weakly_canonical(fs::absolute(folder));
    for (const std::string& input : {run.first, run.second}) {
        const fs::path compared = fs::weakly_canonical(fs::absolute(input));
        if (std::mismatch(compared.begin(), compared.end(), place.begin(), place.end()).first == compared.end())
            throw InputError(
                fmt::format("{}{} lies in {}, which is compared; name another folder", option, folder, input));
    }
    requireWritableFolder(folder);
}

}  // namespace

int compareFolders(const CompareRun& run)
{
    checkOutput("--difference ", run.difference, run);
    checkOutput("--heatmap ", run.heatmap, run);
    RunPaths paths;
    for (const std::string& input : run.otherInputs) paths.reads(input);
    ReportOutputs outputs(run.reports, paths);
    const FolderNames names = namesOf(run);
    for (const auto& [folder, only] : {std::pair{&run.first, &names.missing}, std::pair{&run.second, &names.added}})
        for (const auto* list : {&names.both, only})
            for (const std::string& name : *list) paths.reads((fs::path(*folder) / name).string());
    paths.check();
    outputs.open();
    compareAll(run, names, outputs);
    const std::vector<ReportEntry> entries = outputs.finish(headOf(run), suiteOf(run));
    const bool equal = std::ranges::none_of(
        entries, [](const ReportEntry& entry) { return entry.failed() && entry.status != Status::Unreadable; });
    if (run.json) printJson(run, names, entries, equal);
    else if (!run.quiet) printEntries(entries);
    bool unreadable = false;
    for (const ReportEntry& entry : entries) {
        if (entry.status != Status::Unreadable) continue;
        tellUser("knuckle: " + entry.line);
        unreadable = true;
    }
    if (unreadable) return EXIT_INPUT;
    return equal ? EXIT_FINE : EXIT_DIFFERENT;
}

}  // namespace knuckle
