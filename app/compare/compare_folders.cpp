#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <thread>

#include "app/compare/compare_run.h"
#include "app/run/exit_codes.h"
#include "app/run/tell.h"
#include "render/compare/parallel.h"
#include "sim/base/errors.h"
#include "sim/base/files/endings.h"
#include "sim/base/files/output_file.h"
#include "sim/rig/anatomy/names/name_pattern.h"

namespace knuckle {

namespace {

namespace fs = std::filesystem;

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
    std::set<std::string> names;
    std::error_code error;
    for (fs::recursive_directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
        if (std::error_code ignored; entry->is_directory(ignored)) continue;
        const std::string name = entry->path().lexically_relative(folder).generic_string();
        if (isWanted(name, patterns)) names.insert(name);
    }
    if (error) throw InputError(fmt::format("folder {} cannot be read: {}", folder, error.message()));
    return names;
}

/// One image of both folders.
struct Pair {
    std::string name, error;  ///< `error`: why it could not be read; empty where it was.
    ComparedImages images;
};

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

Pair comparePair(const CompareRun& run, const std::string& name)
{
    Pair pair{name, {}, {}};
    try {
        pair.images = compareImageFiles(run, (fs::path(run.first) / name).string(),
                                        (fs::path(run.second) / name).string(), name, 1);
        if (!pair.images.verdict.equal) {
            writeBeside(run.difference, name, pair.images.differencePng);
            writeBeside(run.heatmap, name, pair.images.heatmapPng);
        }
        // Figures of single pixels are large, and there may be thousands of images.
        pair.images.comparison.differences.marks = {};
        pair.images.comparison.flip.errors = {};
        pair.images.differencePng = pair.images.heatmapPng = {};
    } catch (const InputError& error) {
        pair.error = error.what();
    }
    return pair;
}

/// Other sizes first, then by the worst tile and the mean of FLIP; names decide where those are equal.
void sortWorstFirst(std::vector<Pair>& pairs)
{
    std::stable_sort(pairs.begin(), pairs.end(), [](const Pair& p, const Pair& q) {
        if (p.images.verdict.equal != q.images.verdict.equal) return q.images.verdict.equal;
        if (p.images.comparison.sameSize() != q.images.comparison.sameSize()) return q.images.comparison.sameSize();
        if (p.images.comparison.tile.score != q.images.comparison.tile.score)
            return p.images.comparison.tile.score > q.images.comparison.tile.score;
        return p.images.comparison.flip.mean > q.images.comparison.flip.mean;
    });
}

void printPairs(const CompareRun& run, const FolderNames& names, const std::vector<Pair>& pairs, size_t different)
{
    for (const Pair& pair : pairs) {
        if (!pair.error.empty() || pair.images.verdict.equal) continue;
        const std::string places = placesLine(pair.images.comparison);
        fmt::print("{}: {}{}{}\n", pair.name, verdictLine(pair.images.comparison, pair.images.verdict),
                   places.empty() ? "" : "; ", places);
    }
    for (const std::string& name : names.missing) fmt::print("{}: missing in {}\n", name, run.second);
    for (const std::string& name : names.added) fmt::print("{}: new, not in {}\n", name, run.first);
    std::string rest;
    if (!names.missing.empty()) rest += fmt::format(", {} missing", names.missing.size());
    if (!names.added.empty()) rest += fmt::format(", {} new{}", names.added.size(), run.allowNew ? " (allowed)" : "");
    const auto failed = std::ranges::count_if(pairs, [](const Pair& pair) { return !pair.error.empty(); });
    if (failed > 0) rest += fmt::format(", {} cannot be read", failed);
    fmt::print("{} of {} images {}{}\n", different, pairs.size(), different == 1 ? "differs" : "differ", rest);
}

void printJson(const CompareRun& run, const FolderNames& names, const std::vector<Pair>& pairs, bool equal)
{
    Json json = {{"first", run.first},       {"second", run.second}, {"verdict", equal ? "equal" : "different"},
                 {"missing", names.missing}, {"new", names.added},   {"unreadable", Json::array()},
                 {"images", Json::array()}};
    for (const Pair& pair : pairs) {
        Json entry = {{"name", pair.name}};
        if (pair.error.empty()) entry.update(comparisonToJson(pair.images, run.settings));
        else entry["error"] = pair.error;
        json[pair.error.empty() ? "images" : "unreadable"].push_back(std::move(entry));
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
    const FolderNames names = namesOf(run);
    std::vector<Pair> pairs(names.both.size());
    forEachParallel(pairs.size(), std::max(1u, std::thread::hardware_concurrency()),
                    [&](size_t i) { pairs[i] = comparePair(run, names.both[i]); });
    sortWorstFirst(pairs);
    const auto different = std::ranges::count_if(
        pairs, [](const Pair& pair) { return pair.error.empty() && !pair.images.verdict.equal; });
    const bool equal = different == 0 && names.missing.empty() && (names.added.empty() || run.allowNew);
    if (run.json) printJson(run, names, pairs, equal);
    else if (!run.quiet) printPairs(run, names, pairs, static_cast<size_t>(different));
    bool failed = false;
    for (const Pair& pair : pairs) {
        if (pair.error.empty()) continue;
        tellUser("knuckle: " + pair.error);
        failed = true;
    }
    if (failed) return EXIT_INPUT;
    return equal ? EXIT_FINE : EXIT_DIFFERENT;
}

}  // namespace knuckle
