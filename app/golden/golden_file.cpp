#include "app/golden/golden_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <set>

#include "app/compare/ignored_words.h"
#include "app/files/files_below.h"
#include "app/schema/schema.h"
#include "render/reader/picture_file.h"
#include "sim/base/errors.h"
#include "sim/base/files/output_file.h"
#include "sim/rig/anatomy/names/name_pattern.h"

namespace knuckle {

namespace {

namespace fs = std::filesystem;

std::string beside(const std::string& folder, const std::string& path)
{
    return (fs::path(folder) / path).lexically_normal().string();
}

void readScene(const JsonFile& file, Golden& golden)
{
    const Json& root = file.root;
    golden.scene = beside(golden.folder, root["scene"]);
    for (const auto& [path, value] : root["set"].items()) golden.changes.push_back({path, value});
    golden.changes.push_back({"render.width", root["size"][0]});
    golden.changes.push_back({"render.height", root["size"][1]});
    if (!root.contains("frames")) failAt(file.path, "/frames", "is missing; name those to compare, as [1, 60]");
    golden.frames = root["frames"].get<std::vector<uint64_t>>();
    if (!std::ranges::is_sorted(golden.frames, std::less_equal{}) || golden.frames.empty())
        failAt(file.path, "/frames", "must be in order, each frame once");
}

void readImages(const JsonFile& file, Golden& golden)
{
    const Json& root = file.root;
    golden.command = root.value("command", "");
    golden.commandFolder = beside(golden.folder, root["folder"]);
    golden.images = root["images"].get<std::vector<std::string>>();
    std::set<std::string> stems;
    for (const std::string& image : golden.images)
        if (!stems.insert(Golden::imageStem(image)).second)
            failAt(file.path, "/images",
                   fmt::format("has two named {}; give them goldens of their own", Golden::imageStem(image)));
}

/// Refuses limits for a name that no picture has.
void checkNames(const JsonFile& file, const Golden& golden)
{
    std::vector<std::string> stems;
    for (const uint64_t frame : golden.frames) stems.push_back(golden.frameStem(frame));
    for (const std::string& image : golden.images) stems.push_back(Golden::imageStem(image));
    for (const auto& named : golden.pictures.names) {
        const std::string& pattern = named.first;
        if (std::ranges::none_of(stems, [&](const std::string& stem) { return matchesPattern(stem, pattern); }))
            failAt(file.path, "/pictures/names/" + pattern, "no picture has that name; " + suggestion(pattern, stems));
    }
}

void readPictures(const JsonFile& file, Golden& golden)
{
    const auto found = file.root.find("pictures");
    if (found == file.root.end()) return;
    golden.pictures = limitsOf(*found);
    checkNames(file, golden);
    IgnoredParts& ignored = golden.settings.ignored;
    const std::string place = file.path + ": /pictures/";
    for (const Json& word : found->value("ignore", Json::array()))
        ignored.boxes.push_back(parseBox(place + "ignore", word));
    for (const Json& word : found->value("ignoreColors", Json::array()))
        ignored.colors.push_back(parseColor(place + "ignoreColors", word));
    golden.settings.ignoreAntialiasing = found->value("ignoreAntialiasing", false);
    if (found->contains("mask"))
        ignored.mask = std::make_shared<const Picture>(readPicture(beside(golden.folder, (*found)["mask"])));
}

std::map<std::string, GoldenRecord> readRecords(const JsonFile& file)
{
    std::map<std::string, GoldenRecord> records;
    for (const auto& [key, json] : file.root["recorded"].items()) {
        const auto isPlain = [](unsigned char letter) {
            return std::isalnum(letter) != 0 || letter == '-' || letter == '.';
        };
        if (!std::ranges::all_of(key, isPlain))
            failAt(file.path, "/recorded", fmt::format("\"{}\" must have only letters, digits, - and .", key));
        GoldenRecord record{json["driver"], json["device"], json["program"], json["file"]};
        for (const auto& [frame, hash] : json["states"].items()) {
            if (frame.empty() || frame.size() > 7 || frame.find_first_not_of("0123456789") != std::string::npos)
                failAt(file.path, "/recorded/" + key + "/states", fmt::format("\"{}\" is no frame", frame));
            if (hash.get<std::string>().find_first_not_of("0123456789abcdef") != std::string::npos)
                failAt(file.path, "/recorded/" + key + "/states/" + frame, "must be 16 digits of 0-9 and a-f");
            record.states[std::stoul(frame)] = hash;
        }
        records[key] = std::move(record);
    }
    return records;
}

/// Whether a golden is meant by a name: its own, that of a folder around it, or a pattern.
bool isNamed(const std::string& golden, const std::string& name)
{
    return golden == name || golden.starts_with(name + "/") || matchesPattern(golden, name);
}

std::string lastPart(const std::string& folder)
{
    const fs::path path = fs::weakly_canonical(fs::absolute(folder));
    return (path.has_filename() ? path : path.parent_path()).filename().string();
}

/// Paths of the folders below `folder`, or of itself as ".", that have a golden.json; sorted.
std::set<std::string> foldersOf(const std::string& folder)
{
    std::set<std::string> found;
    for (const fs::path file : filesBelow(folder))
        if (file.filename() == GOLDEN_FILE)
            found.insert(file.has_parent_path() ? file.parent_path().generic_string() : ".");
    return found;
}

}  // namespace

std::string Golden::path() const
{
    return (fs::path(folder) / GOLDEN_FILE).string();
}

std::string Golden::imagePath(const std::string& image) const
{
    return beside(commandFolder, image);
}

std::string Golden::imageStem(const std::string& image)
{
    return fs::path(image).stem().string();
}

std::string Golden::imageReference(const std::string& image, const std::string& key) const
{
    return reference(imageStem(image), key, fs::path(image).extension().string());
}

std::string Golden::frameStem(uint64_t frame) const
{
    return fmt::format("frame_{:04}", frame);
}

std::string Golden::reference(const std::string& stem, const std::string& key, const std::string& ending) const
{
    return (fs::path(folder) / (stem + (key.empty() ? "" : "@" + key) + ending)).string();
}

Golden readGolden(const std::string& folder, const std::string& name)
{
    return parseGolden(folder, name, readJsonFile((fs::path(folder) / GOLDEN_FILE).string()).root);
}

Golden parseGolden(const std::string& folder, const std::string& name, const Json& document)
{
    static const Schema schema("golden.schema.json");
    Golden golden{.name = name, .folder = folder, .document = document};
    JsonFile file{golden.path(), document};
    schema.complete(file);
    const bool scene = file.root.contains("scene");
    if (scene == file.root.contains("images")) failAt(file.path, "", "must have either \"scene\" or \"images\"");
    if (scene) readScene(file, golden);
    else readImages(file, golden);
    const Json &states = file.root["states"], &elsewhere = file.root["elsewhere"];
    golden.states = {states["distance"], states["share"]};
    golden.statesAdvisory = elsewhere["states"] == "advisory";
    golden.picturesAdvisory = elsewhere["pictures"] == "advisory";
    readPictures(file, golden);
    golden.recorded = readRecords(file);
    return golden;
}

void writeGolden(Golden& golden)
{
    Json recorded = Json::object();
    for (const auto& [key, record] : golden.recorded) {
        Json states = Json::object();
        for (const auto& [frame, hash] : record.states) states[std::to_string(frame)] = hash;
        recorded[key] = {{"driver", record.driver}, {"device", record.device}, {"program", record.program}};
        if (!record.file.empty()) recorded[key]["file"] = record.file;
        if (!states.empty()) recorded[key]["states"] = states;
    }
    golden.document["recorded"] = recorded;
    writeFile(golden.path(), golden.document.dump(2) + "\n");
}

std::vector<Golden> findGoldens(const std::string& folder, const std::vector<std::string>& names)
{
    const std::set<std::string> all = foldersOf(folder);
    if (all.empty())
        throw InputError(fmt::format("no {} in {} or below; `knuckle golden add` makes one", GOLDEN_FILE, folder));
    for (const std::string& name : names)
        if (std::ranges::none_of(all, [&](const std::string& golden) { return isNamed(golden, name); }))
            throw InputError(
                fmt::format("no golden {} in {}; {}", name, folder, suggestion(name, {all.begin(), all.end()})));
    std::vector<Golden> goldens;
    for (const std::string& path : all) {
        const auto named = [&](const std::string& name) { return isNamed(path, name); };
        if (!names.empty() && std::ranges::none_of(names, named)) continue;
        const std::string at = path == "." ? folder : (fs::path(folder) / path).string();
        const std::string own = path == "." ? lastPart(folder) : path;
        try {
            goldens.push_back(readGolden(at, own));
        } catch (const InputError& error) {
            goldens.push_back({.name = own, .folder = at, .problem = error.what()});
        }
    }
    return goldens;
}

}  // namespace knuckle
