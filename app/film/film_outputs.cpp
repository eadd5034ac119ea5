#include "app/film/film_outputs.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "sim/base/errors.h"
#include "sim/base/files/endings.h"

namespace knuckle {

bool isFilm(const std::string& path)
{
    const OutputPlace place = OutputPlace::of(path);
    if (place.kind == OutputPlace::Kind::Stream) return true;
    const std::string ending = endingOf(path);
    const bool known = std::ranges::count(FILM_ENDINGS, ending) > 0, folder = place.kind == OutputPlace::Kind::Folder;
    if (path.ends_with('/') || ending.empty() || (folder && !known)) return false;
    if (folder)
        throw InputError(fmt::format("-o {0}: is a folder; name the film otherwise, or {0}/ for frames", place.given));
    if (known) return true;
    throw InputError(fmt::format("-o {0}: films are written as .mp4, .mov or .mkv, frames into a folder; name one of "
                                 "them, or {0}/ for a folder",
                                 place.given));
}

void addOutputs(const FilmOptions& options, const Exporters& exporters, const Scene& scene, RunPaths& paths)
{
    for (const std::string& path : options.outputs) {
        if (isFilm(path)) paths.writes(path);
        else paths.writesFrames(path, ".png");
    }
    for (const auto& exporter : exporters) exporter->addPaths(scene, paths);
    for (const std::string& path : {options.stats, options.record.states, options.record.last})
        if (!path.empty()) paths.writes(path);
}

FilmOutputs::FilmOutputs(const Scene& scene, const FilmOptions& options, Exporters chosen)
    : exporters(std::move(chosen)), needs(needsOf(exporters))
{
    for (const std::string& path : options.outputs)
        sinks.push_back(isFilm(path) ? filmSink(path, scene.render.width, scene.render.height, scene.framesPerSecond)
                                     : pngSink(path));
    for (const auto& exporter : exporters) exporter->begin(scene);
    if (!options.stats.empty()) stats.emplace(options.stats);
}

}  // namespace knuckle
