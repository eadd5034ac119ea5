#include "app/states/run_fingerprint.h"

#include <fmt/format.h>

#include <array>
#include <filesystem>

#include "app/states/file_checksum.h"
#include "sim/base/errors.h"
#include "sim/base/fnv_hash.h"
#include "sim/world/fingerprint/fingerprint.h"

namespace knuckle {

namespace {

struct Field {
    const char *key, *words;
    std::string RunFingerprint::*value;
    bool ofState;  ///< Whether states depend on it, and not pictures alone.
};

constexpr std::array FIELDS{
    Field{"program", "the program", &RunFingerprint::program, true},
    Field{"build", "the program's build", &RunFingerprint::build, true},
    Field{"shaders", "the shaders' hash", &RunFingerprint::shaders, true},
    Field{"driver", "the driver", &RunFingerprint::driver, true},
    Field{"device", "the device", &RunFingerprint::device, true},
    Field{"world", "the hash of the scene's world", &RunFingerprint::world, true},
    Field{"scene", "the hash of the scene's file", &RunFingerprint::scene, false},
    Field{"files", "the hash of the files that the scene reads", &RunFingerprint::files, false},
};

std::vector<std::string> differ(const RunFingerprint& here, const RunFingerprint& there, bool statesOnly)
{
    std::vector<std::string> phrases;
    for (const Field& field : FIELDS) {
        const std::string &own = here.*field.value, &other = there.*field.value;
        if (own == other || (statesOnly && !field.ofState)) continue;
        phrases.push_back(fmt::format("{} is \"{}\", not \"{}\"", field.words, own, other));
    }
    return phrases;
}

}  // namespace

std::string programVersion()
{
    return "knuckle " KNUCKLE_VERSION;
}

Json RunFingerprint::json() const
{
    Json json = Json::object();
    for (const Field& field : FIELDS) json[field.key] = this->*field.value;
    return json;
}

RunFingerprint RunFingerprint::read(const Json& json, const std::string& file)
{
    RunFingerprint print;
    for (const Field& field : FIELDS) {
        const auto found = json.find(field.key);
        if (found == json.end() || !found->is_string()) failAt(file, std::string("/") + field.key, "is missing");
        print.*field.value = *found;
    }
    return print;
}

RunFingerprint fingerprintOf(const Scene& scene, const Gpu& gpu)
{
    static const std::string build = fileChecksum("/proc/self/exe");
    FnvHash files;
    // An actor does without the model that it was made of.
    for (const std::string& file : scene.files)
        files.add(std::string_view(std::filesystem::exists(file) ? fileChecksum(file) : "missing"));
    return {.program = programVersion(),
            .build = build,
            .shaders = hashText(gpu.shaders().hash()),
            .driver = gpu.device().version,
            .device = gpu.device().name,
            .world = hashText(fingerprint(scene.world)),
            .scene = hashText(scene.documentHash),
            .files = hashText(files.value())};
}

std::vector<std::string> differences(const RunFingerprint& here, const RunFingerprint& there)
{
    return differ(here, there, false);
}

std::vector<std::string> stateDifferences(const RunFingerprint& here, const RunFingerprint& there)
{
    return differ(here, there, true);
}

}  // namespace knuckle
