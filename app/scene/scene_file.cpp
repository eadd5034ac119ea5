#include "app/scene/scene_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <utility>

#include "app/json/fields.h"
#include "app/scene/scene_parts.h"
#include "app/scene/scene_ropes.h"
#include "app/schema/schema.h"
#include "sim/base/errors.h"

namespace knuckle {

namespace {

constexpr std::array<float, 3> WATER_COLOR = {0.05f, 0.25f, 0.5f};

/// A preset's name becomes an object, and the paper's choices stand where the schema would put the other defaults.
void expandSolver(Json& root)
{
    if (!root.is_object() || !root.contains("solver")) return;
    Json& solver = root["solver"];
    if (solver == "paper" || solver == "default") solver = Json{{"preset", solver}};
}

void fillPaperChoices(Json& root)
{
    if (!root.is_object() || !root.contains("solver")) return;
    Json& solver = root["solver"];
    if (!solver.is_object() || solver.value("preset", Json()) != "paper") return;
    const Json paper = writeFields(paperSettings());
    for (const auto& [key, value] : paper.items()) {
        if (!solver.contains(key)) solver[key] = value;
    }
}

/// A camera whose position the scene gives is not automatic.
void settleCamera(Json& root)
{
    if (!root.is_object() || !root.contains("camera") || !root["camera"].is_object()) return;
    Json& camera = root["camera"];
    const bool placed = camera.contains("position") || camera.contains("target");
    if (placed && !camera.contains("automatic")) camera["automatic"] = false;
}

/// Without a colour of their own, fluids are blue.
void settleMaterials(Json& root)
{
    if (!root.is_object() || !root.contains("materials") || !root["materials"].is_object()) return;
    for (Json& material : root["materials"]) {
        const bool fluid = material.is_object() && material.value("fluid", Json()) == true;
        if (fluid && !material.contains("color")) material["color"] = WATER_COLOR;
    }
}

/// A scene with an emitter may leave out `objects`.
void settleObjects(Json& root)
{
    if (root.is_object() && root.contains("emitters") && !root.contains("objects")) root["objects"] = Json::array();
}

/// Pointer to an `animation` or a `pose` that names no clip, which would be as if it were not there; empty for none.
std::string emptyAnimation(const Json& root)
{
    if (!root.is_object() || !root.contains("objects") || !root["objects"].is_array()) return {};
    const Json nothing = "";
    const Json& objects = root["objects"];
    for (size_t i = 0; i < objects.size(); ++i)
        for (const char* key : {"animation", "pose"}) {
            if (!objects[i].is_object() || !objects[i].contains(key) || !objects[i][key].is_object()) continue;
            const Json& clip = objects[i][key];
            if (clip.value("clip", nothing) == nothing && clip.value("file", nothing) == nothing)
                return fmt::format("/objects/{}/{}", i, key);
        }
    return {};
}

void applyOverrides(Json& root, const std::vector<Override>& overrides)
{
    for (const Override& change : overrides) {
        expandSolver(root);
        applyOverride(root, change);
    }
}

/// The document with every default filled in.
JsonFile completed(JsonFile file)
{
    static const Schema schema("scene.schema.json");
    const std::string empty = emptyAnimation(file.root);
    expandSolver(file.root);
    fillPaperChoices(file.root);
    settleCamera(file.root);
    settleMaterials(file.root);
    settleObjects(file.root);
    schema.complete(file);
    if (!empty.empty())
        failAt(file.path, empty,
               "names no clip; give its `clip` (`knuckle voxelize` lists them), or the `file` of another model");
    return file;
}

void checkFriction(const JsonFile& file, const Json& json, const std::string& pointer)
{
    const double staticFriction = json.at("staticFriction"), kineticFriction = json.at("kineticFriction");
    if (kineticFriction <= staticFriction) return;
    failAt(file.path, pointer + "/kineticFriction",
           fmt::format("{} is above staticFriction, {}; lower it or raise the other", kineticFriction, staticFriction));
}

std::map<std::string, uint32_t> addMaterials(const JsonFile& file, WorldBuilder& builder)
{
    std::map<std::string, uint32_t> indices;
    for (const auto& [name, json] : file.root["materials"].items()) {
        checkFriction(file, json, "/materials/" + name);
        Material material = readFields<Material>(json);
        material.name = name;
        indices[name] = builder.addMaterial(material);
    }
    if (!indices.contains("default")) {
        Material material;
        material.name = "default";
        indices["default"] = builder.addMaterial(material);
    }
    if (!indices.contains("water")) {
        Material water;
        water.name = "water";
        water.fluid = true;
        water.color = Vector3f(WATER_COLOR.data());
        indices["water"] = builder.addMaterial(water);
    }
    return indices;
}

/// Without a diameter of its own, a scene has the finest that its actors ask for: those with joints, if there are any.
/// @param context gets what was read, and the note.
void settleDiameter(JsonFile& file, SceneContext& context)
{
    const Json& objects = file.root["objects"];
    std::pair finest{true, 0.0f};  // without joints, at what diameter
    std::string asked;
    for (size_t i = 0; i < objects.size(); ++i) {
        if (objects[i]["type"] != "actor") continue;
        const Actor& actor = actorAlone(context, objects[i], fmt::format("/objects/{}", i));
        const std::pair own{actor.joints.empty(), actor.diameter};
        if (!asked.empty() && own >= finest) continue;
        asked = objects[i]["file"];
        finest = own;
    }
    if (asked.empty()) return;
    file.root["diameter"] = finest.second;
    context.notes.push_back(fmt::format("/diameter is {:.3g} m, as fits {}.", finest.second, asked));
}

/// The files of which models are drawn by their meshes. @param all of them.
std::set<std::string> drawnFiles(const SceneContext& context, const Json& objects, bool all)
{
    std::set<std::string> files;
    for (const Json& object : objects)
        if (object.contains("file") && (all || showsSkin(object))) files.insert(besideScene(context, object["file"]));
    return files;
}

RenderSettings readRender(const JsonFile& file, const World& world)
{
    RenderSettings render = readFields<RenderSettings>(file.root["render"]);
    render.camera = readFields<CameraSettings>(file.root["camera"]);
    render.light = readFields<LightSettings>(file.root["light"]);
    if (render.light.direction.norm() < 1e-6f) failAt(file.path, "/light/direction", "must not be zero");
    if (render.camera.kind != CameraKind::Follow) return render;
    std::string& follow = render.camera.follow;
    std::vector<std::string> names;
    for (const Object& object : world.objects) names.push_back(object.name);
    if (names.empty()) failAt(file.path, "/camera/kind", "\"follow\" needs an object with a body; take \"fixed\"");
    if (follow.empty()) follow = names.front();
    if (std::find(names.begin(), names.end(), follow) != names.end()) return render;
    if (names.size() > 12) names.resize(12);
    failAt(file.path, "/camera/follow",
           fmt::format("there is no object \"{}\"; {}", follow, suggestion(follow, names)));
}

}  // namespace

uint64_t Scene::frameCount() const
{
    return static_cast<uint64_t>(std::max(1.0, std::round(duration * framesPerSecond)));
}

uint32_t stepsForFrame(double framesPerSecond, double timeStep)
{
    const double frame = 1.0 / framesPerSecond;
    const double fewer = std::max(1.0, std::floor(frame / timeStep)), more = fewer + 1.0;
    const bool moreIsNearer = std::abs(frame / more - timeStep) < std::abs(frame / fewer - timeStep);
    return static_cast<uint32_t>(moreIsNearer ? more : fewer);
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
    Json root = {{"solver", preset}, {"objects", anything}};
    applyOverrides(root, overrides);
    const JsonFile file = completed({"--set", root});
    return readFields<Settings>(file.root["solver"]);
}

Scene loadScene(const std::string& path, const std::vector<Override>& overrides, bool drawn)
{
    JsonFile file = readJsonFile(path);
    applyOverrides(file.root, overrides);
    const bool givesDiameter = file.root.is_object() && file.root.contains("diameter");
    file = completed(std::move(file));
    const Json& root = file.root;
    Scene scene;
    scene.name = root["name"];
    if (scene.name.empty()) scene.name = std::filesystem::path(path).stem().string();
    scene.description = root["description"];
    scene.duration = root["duration"];
    scene.framesPerSecond = root["fps"];
    Settings settings = readFields<Settings>(root["solver"]);
    scene.stepsPerFrame = stepsForFrame(scene.framesPerSecond, settings.timeStep);
    settings.timeStep = static_cast<float>(1.0 / (scene.framesPerSecond * scene.stepsPerFrame));

    // What its actors ask for is known only when they are read.
    WorldBuilder trial(0.5f * root["diameter"].get<float>(), settings);
    SceneContext known{path, trial, {}};
    known.drawnFiles = drawnFiles(known, root["objects"], drawn);
    if (!givesDiameter) settleDiameter(file, known);
    WorldBuilder builder(0.5f * root["diameter"].get<float>(), settings);
    builder.setFluidSpacing(root["fluidSpacing"]);
    SceneContext context{path,          builder,         addMaterials(file, builder), std::move(known.actors),
                         known.imports, known.drawnFiles};
    context.notes = known.notes;
    context.duration = scene.duration;
    context.files = known.files;
    for (size_t i = 0; i < root["colliders"].size(); ++i) {
        checkFriction(file, root["colliders"][i], fmt::format("/colliders/{}", i));
        addColliders(context, root["colliders"][i], i);
        context.colliderEntries.resize(builder.world().colliders.size(), i);
    }
    const Json& objects = root["objects"];
    if (objects.empty() && root["emitters"].empty()) failAt(path, "/objects", "is an array of 0, must be at least 1");
    for (const bool rows : {false, true})
        for (size_t i = 0; i < objects.size(); ++i)
            if (isRopeObject(objects[i]) == rows) addObjects(context, objects[i], i);
    addTouches(context);
    addEmitters(context, root, scene.duration);
    try {
        scene.world = builder.build();
    } catch (const InputError& error) {
        throw InputError(fmt::format("{}: {}", path, error.what()));
    }
    scene.notes = context.notes;
    scene.warnings = context.warnings;
    if (settings.substeps > 0 && scene.world.settings.substeps > settings.substeps)
        scene.warnings.push_back(fmt::format("/solver/substeps: {} are too few for fluid as deep as this: {} are taken",
                                             settings.substeps, scene.world.settings.substeps));
    scene.actors = std::move(context.actorUses);
    scene.imports = context.imports;
    scene.files = std::move(context.files);
    for (const SceneActor& use : scene.actors)
        if (!use.actor->model.file.empty()) scene.files.push_back(use.actor->model.file);
    std::ranges::sort(scene.files);
    scene.files.erase(std::unique(scene.files.begin(), scene.files.end()), scene.files.end());
    scene.render = readRender(file, scene.world);
    return scene;
}

}  // namespace knuckle
