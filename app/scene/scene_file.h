#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/scene/overrides.h"
#include "app/scene/picture/film_clock.h"
#include "render/settings.h"
#include "sim/rig/actor.h"
#include "sim/rig/import/imports.h"
#include "sim/world/world.h"

namespace knuckle {

/// An actor of the scene, and its source.
struct SceneActor {
    std::shared_ptr<const Actor> actor;
    std::vector<uint32_t> objects;  ///< Its copies: indices into World::objects.
};

/// Where a scene goes on from.
struct SceneStart {
    std::string file;    ///< Of states.
    uint64_t frame = 0;  ///< 0: its last.
};

/// The contents of a scene file.
struct Scene {
    std::string file;  ///< Its path.
    std::string name;
    std::string description;
    std::string document;  ///< JSON with all changes, from which the scene can be read again.
    std::optional<SceneStart> start;
    World world;
    RenderSettings render;
    double framesPerSecond = 60.0;
    double duration = 0.0;  ///< Of the film [s].
    std::vector<SceneActor> actors;
    std::shared_ptr<Imports> imports;   ///< The models that were read for it.
    std::vector<std::string> files;     ///< All files read for it, except its own.
    std::vector<std::string> notes;     ///< Deviations from the file, one sentence each.
    std::vector<std::string> warnings;  ///< Things not drawn as the file says: a run prints these, too.
    uint64_t documentHash = 0;          ///< Of the file with all defaults, except `duration` and `description`.
    uint32_t stepsPerFrame = 1;         ///< World::settings.timeStep is 1 / (framesPerSecond * stepsPerFrame).
    FilmClock clock;                    ///< How many of them a frame takes, where there is slow or fast motion.

    /// Frame 1 shows time 0.
    uint64_t frameCount() const;
    /// Time that passes in the simulation up to the last frame [s].
    double simulatedSeconds() const;
    /// Of the film [s].
    double timeOf(uint64_t frame) const { return static_cast<double>(frame - 1) / framesPerSecond; }
};

/// Reads, checks and builds a scene. Needs no GPU; models are imported and filled with particles.
/// @throws InputError, one line with the file and the JSON pointer of the fault.
/// @param drawn whether models are read with their looks, for later drawing.
Scene loadScene(const std::string& path, const std::vector<Override>& overrides = {}, bool drawn = false);

/// The same from Scene::document. @param path of the scene's file, beside which other files are searched.
Scene loadStoredScene(const std::string& path, const std::string& document);

/// The clock of a scene from Scene::document. @param stepsPerFrame of its run.
FilmClock storedClock(const std::string& path, const std::string& document, uint32_t stepsPerFrame);

/// The number of steps a frame for which 1 / (framesPerSecond * steps) is nearest to `timeStep` [s].
uint32_t stepsForFrame(double framesPerSecond, double timeStep);

}  // namespace knuckle
