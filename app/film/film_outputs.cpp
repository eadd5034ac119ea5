#include "app/film/film_outputs.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "render/output/film_kinds.h"
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
    throw InputError(fmt::format("-o {0}: films are written as {1}, frames into a folder; name one of them, or "
                                 "{0}/ for a folder",
                                 place.given, choiceOf(FILM_ENDINGS)));
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

FilmOutputs::FilmOutputs(const Scene& scene, const FilmOptions& options, const FrameRange& range, Exporters chosen,
                         Checkpoint* checkpoint)
    : exporters(std::move(chosen)), needs(needsOf(exporters))
{
    for (size_t k = 0; k < options.outputs.size(); ++k) sinks.push_back(makeSink(scene, options, k, range, checkpoint));
    for (const auto& exporter : exporters) exporter->begin(scene);
    if (!options.stats.empty()) stats.emplace(options.stats);
}

std::unique_ptr<FrameSink> FilmOutputs::makeSink(const Scene& scene, const FilmOptions& options, size_t output,
                                                 const FrameRange& range, Checkpoint* checkpoint)
{
    const std::string& path = options.outputs[output];
    if (!isFilm(path)) {
        hasFolders_ = true;
        return pngSink(path, checkpoint != nullptr ? checkpoint->pictures(output, path) : nullptr);
    }
    return filmSink(path, {scene.render.width, scene.render.height, scene.framesPerSecond, options.codec, options.pipe},
                    {range.first, range.last, 1, checkpoint != nullptr ? checkpoint->film(output) : nullptr});
}

bool FilmOutputs::wantsPicture(uint64_t frame) const
{
    return std::ranges::any_of(sinks, [&](const auto& sink) { return sink->wants(frame); });
}

}  // namespace knuckle
