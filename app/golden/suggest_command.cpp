#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <map>
#include <set>

#include "app/golden/golden_commands.h"
#include "app/run/counted.h"
#include "app/run/exit_codes.h"
#include "app/run/progress.h"
#include "app/run/shell_command.h"
#include "render/compare/verdict.h"
#include "sim/base/cores.h"
#include "sim/base/errors.h"

namespace knuckle {

namespace {

/// A way to check goldens that should make no difference.
struct Variant {
    std::string device;  ///< Of --device.
    std::vector<std::string> environment;
};

/// What the pictures of a golden differed by at most, over all variants; and its states.
struct Seen {
    double mean = 0.0, largest = 0.0, share = 0.0, tile = 0.0, flip = 0.0;
    uint64_t pictures = 0;                 ///< Compared ones.
    uint64_t states = 0, otherStates = 0;  ///< Compared ones, and those with other bits.
    double distance = 0.0;                 ///< The largest of them [diameters].
    std::set<std::string> problems;
};

bool isWanted(const DeviceChoice& choice, const DeviceInfo& device)
{
    using Kind = DeviceChoice::Kind;
    if (choice.kind == Kind::Index) return choice.index == device.index;
    return choice.kind == Kind::Auto || device.software == (choice.kind == Kind::Software);
}

std::vector<Variant> variantsOf(const CommonOptions& common, unsigned repeats)
{
    std::vector<Variant> variants;
    std::set<std::string> seen;
    for (const DeviceInfo& device : withPointer(listDevices)) {
        if (!isWanted(DeviceChoice::parse(common.device), device) || !device.problem.empty() ||
            !seen.insert(device.name + device.version).second)
            continue;
        const std::string index = std::to_string(device.index);
        for (unsigned i = 0; i < repeats; ++i) variants.push_back({index, {}});
        if (!device.software) continue;
        for (const unsigned threads : {0u, usableCores()})
            variants.push_back({index, {fmt::format("LP_NUM_THREADS={}", threads)}});
        for (const int bits : {128, 256, 512})
            variants.push_back({index, {fmt::format("LP_NATIVE_VECTOR_WIDTH={}", bits)}});
        variants.push_back({index, {"MESA_LOADER_DRIVER_OVERRIDE=zink"}});
    }
    return variants;
}

void noteState(const Json& state, Seen& seen)
{
    ++seen.states;
    if (state["sameBits"]) return;
    ++seen.otherStates;
    if (state.contains("largest")) seen.distance = std::max(seen.distance, state["largest"].get<double>());
}

void notePicture(const Json& picture, Seen& seen)
{
    const auto raise = [](double& value, const Json& other) { value = std::max(value, other.get<double>()); };
    if (!picture.contains("mean")) return;
    ++seen.pictures;
    raise(seen.mean, picture["mean"]);
    raise(seen.largest, picture["largest"]);
    raise(seen.share, picture["share"]);
    raise(seen.tile, picture["tile"]["score"]);
    raise(seen.flip, picture["flip"]["mean"]);
}

/// Adds what one check has seen. @returns whether it could be run.
bool runVariant(const std::string& folder, const std::vector<std::string>& names, const Variant& variant,
                std::map<std::string, Seen>& seen)
{
    std::string line = quotedForShell(std::filesystem::read_symlink("/proc/self/exe").string()) +
                       " golden check --json --device " + variant.device + " " + quotedForShell(folder);
    for (const std::string& name : names) line += " " + quotedForShell(name);
    const ShellResult result = runShell(line + " 2>/dev/null", "", variant.environment);
    const Json json = Json::parse(result.output, nullptr, false);
    if (json.is_discarded() || !json.contains("goldens")) return false;
    for (const Json& golden : json["goldens"]) {
        Seen& own = seen[golden["name"]];
        for (const Json& item : golden["items"]) {
            if (item.contains("state")) noteState(item["state"], own);
            else if (item.contains("picture")) notePicture(item["picture"], own);
            else own.problems.insert(item["line"]);
        }
    }
    return true;
}

/// Twice what was seen, rounded up to two digits, and at least what a person cannot see.
double limitFor(double seen, double least)
{
    if (2.0 * seen <= least) return least;
    const double unit = std::pow(10.0, std::floor(std::log10(2.0 * seen)) - 1.0);
    return std::ceil(2.0 * seen / unit) * unit;
}

Json suggestionOf(const Seen& seen)
{
    return {{"mean", limitFor(seen.mean, 0.1)},
            {"share", limitFor(seen.share, 0.0005)},
            {"tile", limitFor(seen.tile, 0.25)},
            {"flip", limitFor(seen.flip, 0.005)}};
}

void printSeen(const std::string& name, const Seen& seen)
{
    for (const std::string& problem : seen.problems) fmt::print("{}: {}\n", name, problem);
    if (seen.states > 0)
        fmt::print("{}: {} of {} had other bits{}\n", name, seen.otherStates, counted(seen.states, "state"),
                   seen.otherStates == 0 ? "" : fmt::format(", by up to {} diameters", shortNumber(seen.distance)));
    if (seen.pictures == 0) {
        fmt::print("{}: no picture could be compared\n", name);
        return;
    }
    fmt::print("{}: pictures differed by: mean {}, share {}, tile {}, FLIP {}; suggested: {}\n", name,
               shortNumber(seen.mean), shortNumber(seen.share), shortNumber(seen.tile), shortNumber(seen.flip),
               suggestionOf(seen).dump());
}

}  // namespace

int suggestLimits(const GoldenChoice& choice, const SuggestOptions& options, const CommonOptions& common)
{
    std::vector<Golden> goldens = findGoldens(choice.folder, choice.names);
    // What makes pictures of another program is not run again and again.
    std::erase_if(goldens, [](const Golden& golden) { return !golden.ofScene(); });
    if (goldens.empty()) throw InputError(fmt::format("{}: no golden of a scene is chosen", choice.folder));
    const std::vector<Variant> variants = variantsOf(common, options.repeats);
    std::map<std::string, Seen> seen;
    size_t done = 0, tried = 0;
    std::vector<std::string> names;
    for (const Golden& golden : goldens)
        names.push_back(std::filesystem::path(golden.folder).lexically_relative(choice.folder).generic_string());
    Progress progress("check", variants.size(), common.quiet);
    for (const Variant& variant : variants) {
        if (runVariant(choice.folder, names, variant, seen)) ++done;
        progress.update(++tried);
    }
    if (done == 0) throw DeviceError("no device could check them; see knuckle info");
    for (Golden& golden : goldens) {
        const Seen& own = seen[golden.name];
        if (!common.quiet) printSeen(golden.name, own);
        if (!options.write || own.pictures == 0) continue;
        golden.document["pictures"]["default"].update(suggestionOf(own));
        writeGolden(golden);
    }
    if (!common.quiet)
        fmt::print("{} of {} could run: repeats, threads, widths of vectors, drivers\n", done,
                   counted(variants.size(), "check"));
    return EXIT_FINE;
}

}  // namespace knuckle
