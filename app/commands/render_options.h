#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "app/film/film_run.h"
#include "app/scene/overrides.h"

namespace knuckle {

/// What `knuckle render` is told.
struct RenderOptions {
    std::vector<std::string> scenes;
    std::string scene;  ///< The one that is rendered now.
    std::string frames, size, quality, framesPerSecond, from, resume;
    bool turntable = false, preview = false;
    uint64_t stride = 1;
    std::string labels;  ///< With commas between them.
    std::vector<std::string> outputs, cameras, captions, sets, exports, records;
    FilmOptions film;
};

/// What stands below the options in its help.
std::string renderNotes();

/// What of the command line changes the scene; the schema checks it. @throws InputError.
std::vector<Override> overridesOf(const RenderOptions& options);

/// @throws InputError.
RecordOptions recordOptions(const RenderOptions& options);

/// Adds the outputs: of the scene's own shots, and of cameras. @throws InputError.
void addOutputs(FilmOptions& film, const RenderOptions& options);

/// What of it changes only pictures: captions, and as many bits as an output wants. @throws InputError.
void changePicture(Scene& scene, const RenderOptions& options, const FilmOptions& film);

/// A rough scene instead of one: larger particles where it allows them, a smaller picture, few frames.
struct Preview {
    Scene scene;
    uint64_t stride = 1;
    size_t particles = 0;  ///< Of the real one.
    uint32_t width = 0, height = 0;
    double steps = 1.0;  ///< Time of a frame's steps in the real one, over that here.
};

/// @param load loads the scene with overrides behind its own.
Preview previewOf(const Scene& real, const std::function<Scene(const std::vector<Override>&)>& load);

/// How long the real film would take, from what the rough one took [s].
double estimatedSeconds(const Preview& preview, const RunFigures& figures, uint64_t stride);

/// @throws InputError for options that make no sense together.
void checkOptions(const RenderOptions& options, const FilmOptions& film);

/// @throws InputError for options that are of one scene, with several.
void requireOneScene(const RenderOptions& options);

}  // namespace knuckle
