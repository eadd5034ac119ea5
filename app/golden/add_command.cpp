#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <sstream>

#include "app/files/assets.h"
#include "app/golden/golden_commands.h"
#include "app/golden/golden_record.h"
#include "app/run/counted.h"
#include "app/run/exit_codes.h"
#include "app/scene/scene_file.h"
#include "sim/base/errors.h"
#include "sim/base/files/endings.h"

namespace knuckle {

namespace {

namespace fs = std::filesystem;

/// A path as it is named from a folder that need not be there yet.
std::string seenFrom(const fs::path& folder, const fs::path& path)
{
    return fs::weakly_canonical(fs::absolute(path))
        .lexically_relative(fs::weakly_canonical(fs::absolute(folder)))
        .generic_string();
}

/// "first,middle,last" and numbers, in any order. @throws InputError.
std::vector<uint64_t> parseFrames(const std::string& text, uint64_t count)
{
    std::vector<uint64_t> frames;
    std::istringstream words(text);
    for (std::string word; std::getline(words, word, ',');) {
        uint64_t frame = word == "first" ? 1 : word == "middle" ? (count + 1) / 2 : word == "last" ? count : 0;
        const char* const end = word.data() + word.size();
        if (frame == 0 && std::from_chars(word.data(), end, frame).ptr != end) frame = 0;
        if (frame < 1 || frame > count)
            throw InputError(
                fmt::format("--frames {}: {} must be first, middle, last or a number from 1 to {}", text, word, count));
        frames.push_back(frame);
    }
    std::ranges::sort(frames);
    frames.erase(std::unique(frames.begin(), frames.end()), frames.end());
    if (frames.empty()) throw InputError("--frames: name some, as first,60,last");
    return frames;
}

Json sceneDocument(const AddOptions& options, const fs::path& folder)
{
    std::vector<Override> changes;
    for (const std::string& text : options.sets) {
        changes.push_back(parseOverride(text));
        const std::string& path = changes.back().path;
        if (path.ends_with("render.width") || path.ends_with("render.height") || path.ends_with("render/width") ||
            path.ends_with("render/height"))
            throw InputError(fmt::format("--set {}: the size of a golden's pictures is given by --size", text));
    }
    const std::string& named = options.inputs[0];
    const Scene scene = loadScene(findAsset(named), changes);
    Json document = {{"scene", seenFrom(folder, findAsset(named))}};
    for (const Override& change : changes) document["set"][change.path] = change.value;
    if (!options.size.empty()) {
        const auto [width, height] = parsePictureSize(options.size);
        document["size"] = {width, height};
    }
    document["frames"] = parseFrames(options.frames, scene.frameCount());
    return document;
}

Json imagesDocument(const AddOptions& options, const fs::path& folder)
{
    Json document = Json::object();
    if (!options.command.empty()) document["command"] = options.command;
    document["folder"] = seenFrom(folder, ".");
    for (const std::string& image : options.inputs) document["images"].push_back(seenFrom(".", image));
    return document;
}

bool isSceneFile(const std::string& path)
{
    return endingOf(path) == ".json";
}

void checkAddOptions(const AddOptions& options)
{
    const auto scenes = std::ranges::count_if(options.inputs, isSceneFile);
    if (scenes > 0 && options.inputs.size() > 1)
        throw InputError("a golden is one scene, or images; add each scene by itself");
    if (scenes > 0 && !options.command.empty())
        throw InputError("--command makes images of another program; a scene needs none, leave it out");
    if (scenes == 0 && !(options.sets.empty() && options.size.empty()))
        throw InputError("--set and --size are for a scene; leave them out");
    const fs::path name = fs::path(options.name).lexically_normal();
    if (name.is_absolute() || (!options.name.empty() && (name == "." || *name.begin() == "..")))
        throw InputError(fmt::format("--name {}: must be a path below --in {}", options.name, options.folder));
}

}  // namespace

int addGolden(const AddOptions& options, const CommonOptions& common)
{
    checkAddOptions(options);
    const std::string name = options.name.empty() ? fs::path(options.inputs[0]).stem().string() : options.name;
    const fs::path folder = fs::path(options.folder) / name;
    if (std::error_code ignored; fs::exists(folder / GOLDEN_FILE, ignored))
        throw InputError(fmt::format("{} is there already; `knuckle golden update` makes its references anew, --name "
                                     "gives another name",
                                     (folder / GOLDEN_FILE).string()));
    const bool scene = isSceneFile(options.inputs[0]);
    const Json document = scene ? sceneDocument(options, folder) : imagesDocument(options, folder);
    try {
        static_cast<void>(document.dump());
    } catch (const Json::exception&) {
        throw InputError("a name or a path is no UTF-8, which JSON needs; rename it");
    }
    Golden golden = parseGolden(folder.string(), name, document);
    const auto gpu = openFor({golden}, common);
    const InterruptGuard interrupt;
    const std::string key = scene ? driverKey(gpu->device().name) : "";
    const std::vector<std::string> written = recordGolden(golden, wholeWork(golden, key), gpu.get(), interrupt);
    if (common.quiet) return EXIT_FINE;
    fmt::print("{}: {}\n", golden.folder,
               scene ? fmt::format("frames {} of {}", fmt::join(golden.frames, ", "), options.inputs[0])
                     : counted(golden.images.size(), "image"));
    fmt::print("wrote {}\n", fmt::join(written, ", "));
    return EXIT_FINE;
}

}  // namespace knuckle
