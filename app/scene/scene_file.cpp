#include "app/scene/scene_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <utility>

#include "app/json/fields.h"
#include "app/scene/colliders/scene_colliders.h"
#include "app/scene/matter/scene_emitters.h"
#include "app/scene/matter/soft_limits.h"
#include "app/scene/picture/late_parts.h"
#include "app/scene/picture/scene_picture.h"
#include "app/scene/scene_context.h"
#include "app/scene/scene_document.h"
#include "app/scene/scene_forces.h"
#include "app/scene/scene_materials.h"
#include "app/scene/scene_objects.h"
#include "render/quantities/color_scale.h"
#include "sim/base/errors.h"
#include "sim/base/fnv_hash.h"

namespace knuckle {

namespace {

/// An actor that determines the size of the scene's particles.
struct FinestActor {
    float diameter = 0.0f;  ///< [m]
    std::string file;
};

/// Reads the actors. @returns the one of the smallest particles, among those with joints if there are any, else all.
std::optional<FinestActor> finestActor(SceneFiles& files, const Json& objects)
{
    std::optional<FinestActor> finest;
    std::pair best{true, 0.0f};  // whether without joints, and the diameter
    for (size_t i = 0; i < objects.size(); ++i) {
        if (objects[i]["type"] != "actor") continue;
        const Actor& actor = files.actor(objects[i], fmt::format("/objects/{}", i), 0.0f);
        const std::pair own{actor.joints.empty(), actor.diameter};
        if (finest && own >= best) continue;
        finest = {actor.diameter, objects[i]["file"]};
        best = own;
    }
    return finest;
}

/// Whether a camera goes around once in the whole film.
bool turns(const Json& root)
{
    bool any = root["render"]["camera"] == TURNTABLE;
    for (const Json& shot : root["shots"])
        for (const char* field : {"camera", "inset", "beside"}) any = any || shot[field] == TURNTABLE;
    return any;
}

/// A longer film of the same scene has the same hash, unless a camera's speed depends on it.
uint64_t hashOf(Json root)
{
    if (!turns(root)) root.erase("duration");
    root.erase("description");
    FnvHash hash;
    hash.add(std::string_view(root.dump()));
    return hash.value();
}

/// Properties of the scene that do not belong to the world.
Scene headingOf(const SceneDocument& document)
{
    const Json& root = document.file.root;
    Scene scene;
    scene.file = document.file.path;
    scene.document = document.given.dump();
    scene.name = root["name"];
    if (scene.name.empty()) scene.name = std::filesystem::path(scene.file).stem().string();
    scene.description = root["description"];
    scene.duration = root["duration"];
    scene.framesPerSecond = root["fps"];
    scene.documentHash = hashOf(root);
    return scene;
}

/// All files read for it, each once.
std::vector<std::string> filesOf(const SceneContext& context)
{
    std::vector<std::string> files = context.files.read();
    for (const SceneActor& use : context.actors)
        if (!use.actor->model.file.empty()) files.push_back(use.actor->model.file);
    std::ranges::sort(files);
    files.erase(std::unique(files.begin(), files.end()), files.end());
    return files;
}

/// What cameras may name.
NamedParticles namedParticles(const SceneContext& context, const World& world)
{
    NamedParticles named = context.particles;
    // Fluids, whose particles stand behind all others.
    for (const LooseGroup& group : world.looseGroups) named[group.name].push_back({group.first, group.end});
    for (auto& [name, ranges] : named)
        std::erase_if(ranges, [](const ParticleRange& range) { return range.first == range.end; });
    std::erase_if(named, [](const auto& entry) { return entry.second.empty(); });
    return named;
}

}  // namespace

uint64_t Scene::frameCount() const
{
    return static_cast<uint64_t>(std::max(1.0, std::round(duration * framesPerSecond)));
}

double Scene::simulatedSeconds() const
{
    return static_cast<double>(clock.at(frameCount()).steps) / (framesPerSecond * stepsPerFrame);
}

uint32_t stepsForFrame(double framesPerSecond, double timeStep)
{
    const double frame = 1.0 / framesPerSecond;
    const double fewer = std::max(1.0, std::floor(frame / timeStep)), more = fewer + 1.0;
    const bool moreIsNearer = std::abs(frame / more - timeStep) < std::abs(frame / fewer - timeStep);
    return static_cast<uint32_t>(moreIsNearer && frame / more >= SHORTEST_TIME_STEP ? more : fewer);
}

namespace {

FilmClock clockOf(const Json& root, uint32_t stepsPerFrame)
{
    std::vector<Shot> shots;
    for (const Json& shot : root["shots"]) shots.push_back({.from = shot["from"], .timeScale = shot["timeScale"]});
    // What is out of order is told with the cameras.
    if (!std::ranges::is_sorted(shots, {}, &Shot::from)) shots.clear();
    return FilmClock(root["fps"], stepsPerFrame, shots);
}

Scene sceneOf(const SceneDocument& document, bool drawn)
{
    const Json& root = document.file.root;
    const std::string& path = document.file.path;
    Scene scene = headingOf(document);
    Settings settings = readFields<Settings>(root["solver"]);
    scene.stepsPerFrame = stepsForFrame(scene.framesPerSecond, settings.timeStep);
    scene.clock = clockOf(root, scene.stepsPerFrame);
    settings.timeStep = static_cast<float>(1.0 / (scene.framesPerSecond * scene.stepsPerFrame));

    SceneFiles files(path, settings.solver == SolverKind::Impulse);
    for (const Json& object : root["objects"])
        if (object.contains("file") && (drawn || showsSkin(object))) files.expectDrawn(object["file"]);
    std::optional<FinestActor> finest;
    if (!document.givesDiameter) finest = finestActor(files, root["objects"]);
    WorldBuilder builder(0.5f * (finest ? finest->diameter : root["diameter"].get<float>()), settings);
    builder.setFluidSpacing(root["fluidSpacing"]);

    SceneContext context{path, builder, files, std::max(scene.duration, scene.simulatedSeconds())};
    if (finest)
        context.notes.push_back(fmt::format("/diameter is {:.3g} m, as fits {}.", finest->diameter, finest->file));
    addMaterials(context, root["materials"]);
    addColliders(context, root["colliders"]);
    addObjects(context, root["objects"]);
    addEmitters(context, root);
    addForces(context, root);
    try {
        scene.world = builder.build();
    } catch (const InputError& error) {
        throw InputError(fmt::format("{}: {}", path, error.what()));
    }
    if (settings.substeps > 0 && scene.world.settings.substeps > settings.substeps)
        context.warnings.push_back(
            fmt::format("/solver/substeps: {} are too few for fluid as deep as this: {} are taken", settings.substeps,
                        scene.world.settings.substeps));
    for (std::string& limit : softLimits(scene.world)) context.warnings.push_back(std::move(limit));
    scene.render = readPicture(document.file, scene.world, namedParticles(context, scene.world), files);
    std::ranges::move(lateParts(scene.render, scene.duration), std::back_inserter(context.notes));
    scene.world.shown = keptFor(scene.render);
    scene.files = filesOf(context);
    if (root.contains("start")) {
        scene.start = {files.beside(root["start"]["from"]), root["start"]["frame"]};
        scene.files.push_back(scene.start->file);
    }
    scene.notes = std::move(context.notes);
    scene.warnings = std::move(context.warnings);
    scene.actors = std::move(context.actors);
    scene.imports = files.imports();
    return scene;
}

}  // namespace

Scene loadScene(const std::string& path, const std::vector<Override>& overrides, bool drawn)
{
    return sceneOf(readSceneDocument(path, overrides), drawn);
}

FilmClock storedClock(const std::string& path, const std::string& document, uint32_t stepsPerFrame)
{
    return clockOf(storedSceneDocument(path, document).file.root, stepsPerFrame);
}

Scene loadStoredScene(const std::string& path, const std::string& document)
{
    return sceneOf(storedSceneDocument(path, document), false);
}

}  // namespace knuckle
