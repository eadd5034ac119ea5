#include "app/scene/scene_document.h"

#include <fmt/format.h>

#include <utility>

#include "app/json/fields.h"
#include "app/schema/schema.h"
#include "sim/base/errors.h"

namespace knuckle {

namespace {

/// Adds a number to all seeds below a place.
void shiftSeeds(Json& json, uint32_t shift)
{
    if (!json.is_structured()) return;
    for (auto& [key, value] : json.items()) {
        if (key == "seed" && value.is_number_integer()) value = value.get<uint32_t>() + shift;
        else shiftSeeds(value, shift);
    }
}

SceneDocument completed(JsonFile file, const std::vector<Override>& overrides)
{
    static const Schema schema("scene.schema.json");
    for (const Override& change : overrides) {
        schema.expand(file.root);  // a change may set a field of an object that is given as a string
        applyOverride(file.root, change);
    }
    SceneDocument document{std::move(file)};
    document.given = document.file.root;
    document.givesDiameter = document.file.root.is_object() && document.file.root.contains("diameter");
    schema.complete(document.file);
    Json& root = document.file.root;
    const uint32_t seed = root["seed"];
    root.erase("seed");
    if (seed != 0) shiftSeeds(root, seed);
    if (root["objects"].empty() && root["emitters"].empty())
        failAt(document.file.path, "/objects", "is an array of 0, must be at least 1");
    return document;
}

}  // namespace

SceneDocument readSceneDocument(const std::string& path, const std::vector<Override>& overrides)
{
    return completed(readJsonFile(path), overrides);
}

SceneDocument storedSceneDocument(const std::string& path, const std::string& text)
{
    return completed({path, parseJson(text, path)}, {});
}

Settings loadSettings(const std::string& preset, const std::vector<std::string>& changes)
{
    std::vector<Override> overrides;
    for (const std::string& change : changes) {
        overrides.push_back(parseOverride(change));
        const std::string& path = overrides.back().path;
        if (path.starts_with("solver.") || path.starts_with("/solver/")) continue;
        throw InputError(fmt::format("--set {}: only fields of the solver can be set here, for instance "
                                     "solver.iterations=8",
                                     change));
    }
    const Json anything = Json::array({{{"type", "rigid"}, {"shape", "box"}}});
    const SceneDocument document = completed({"--set", {{"solver", preset}, {"objects", anything}}}, overrides);
    return readFields<Settings>(document.file.root["solver"]);
}

}  // namespace knuckle
