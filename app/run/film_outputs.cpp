#include "app/run/film_outputs.h"

#include <fmt/format.h>

#include <algorithm>

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

void addOutputs(const FilmOptions& options, const Scene& scene, RunPaths& paths)
{
    for (const std::string& path : options.outputs) {
        if (isFilm(path)) paths.writes(path);
        else paths.writesFrames(path, ".png");
    }
    if (!options.plyFolder.empty()) paths.writesFrames(options.plyFolder, ".ply");
    for (const std::string& path : {options.bodyTable, options.measureTable, options.gltf, options.stats})
        if (!path.empty()) paths.writes(path);
    if (options.bvh.empty()) return;
    for (const std::string& path : bvhPaths(options.bvh, scene)) paths.writes(path);
}

FilmOutputs::FilmOutputs(const Scene& scene, const FilmOptions& options) : plyFolder(options.plyFolder)
{
    for (const std::string& path : options.outputs)
        sinks.push_back(isFilm(path) ? filmSink(path, scene.render.width, scene.render.height, scene.framesPerSecond)
                                     : pngSink(path));
    if (!plyFolder.empty()) requireWritableFolder(plyFolder);
    if (!options.bodyTable.empty()) bodies.emplace(options.bodyTable);
    if (!options.measureTable.empty()) measures.emplace(options.measureTable);
    if (!options.bvh.empty()) bvh.emplace(options.bvh, scene);
    if (!options.gltf.empty()) gltf.emplace(options.gltf, scene);
    if (!options.stats.empty()) stats.emplace(options.stats);
}

void FilmOutputs::addBodies(uint64_t frame, const World& world, const std::vector<BodyState>& states)
{
    if (bodies) bodies->write(frame, world, states);
    if (gltf) gltf->add(world, states);
    if (bvh) bvh->add(world, states);
}

void FilmOutputs::finishTables(double framesPerSecond)
{
    if (bodies) bodies->finish();
    if (measures) measures->finish();
    if (gltf) gltf->finish(framesPerSecond);
    if (bvh) bvh->finish(framesPerSecond);
}

}  // namespace knuckle
