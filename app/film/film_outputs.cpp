#include "app/film/film_outputs.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "app/run/tell.h"
#include "render/output/existing_pictures.h"
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
    if (path.ends_with('/') || ending.empty() || (folder && !known) || FrameNames::areGivenBy(path)) return false;
    if (folder)
        throw InputError(fmt::format("-o {0}: is a folder; name the film otherwise, or {0}/ for frames", place.given));
    if (known) return true;
    throw InputError(fmt::format("-o {0}: films are written as {1}, frames into a folder or as {0}_####.png; name "
                                 "one of them, or {0}/ for a folder",
                                 place.given, choiceOf(FILM_ENDINGS)));
}

namespace {

/// Fails where an option is of a kind of pictures that no output is.
void requireTakers(const FilmOptions& film)
{
    if (film.outputs.empty()) return;
    const auto none = [&](bool jpeg) {
        return std::ranges::none_of(film.outputs, [&](const std::string& path) {
            return !isFilm(path) && FrameNames::of(path).areJpeg() == jpeg;
        });
    };
    if (film.depth != 8 && none(false))
        throw InputError(fmt::format("--depth {}: no output is of PNG frames, which alone have it; add -o with a "
                                     "folder, or leave it out",
                                     film.depth));
    if (film.quality != DEFAULT_QUALITY && none(true))
        throw InputError(fmt::format("--quality {}: a number is of JPEG frames, and no output is one; name frames "
                                     "NAME_####.jpg, or take draft, good or final",
                                     film.quality));
}

}  // namespace

void checkOutputs(const FilmOptions& film)
{
    for (const std::string& path : film.outputs)
        if (!isFilm(path)) FrameNames::of(path);
    const auto isStream = [](const std::string& path) {
        return OutputPlace::of(path).kind == OutputPlace::Kind::Stream;
    };
    if (!film.pipe.empty() && !std::ranges::count(PIPE_WORDS, film.pipe))
        throw InputError(fmt::format("--pipe {}: must be {}", film.pipe, choiceOf(PIPE_WORDS)));
    if (!film.pipe.empty() && std::ranges::none_of(film.outputs, isStream))
        throw InputError(fmt::format("--pipe {}: no output is a stream; add -o -", film.pipe));
    requireTakers(film);
    if (film.codec.empty()) return;
    if (!isCodec(film.codec)) throw InputError(fmt::format("--codec {}: must be h264, h265, av1 or vp9", film.codec));
    const bool asked = std::ranges::any_of(film.outputs, [&](const std::string& path) {
        const FilmKind* kind = isFilm(path) ? filmKindOf(path) : nullptr;
        return (kind != nullptr && hasCodecs(*kind)) || (isStream(path) && film.pipe != "raw" && film.pipe != "y4m");
    });
    if (!asked)
        throw InputError(fmt::format("--codec {}: no output is a film that has a codec to choose; name one .mp4, .mov, "
                                     ".mkv or .webm",
                                     film.codec));
}

void addOutputs(const FilmOptions& options, const Exporters& exporters, const Scene& scene, RunPaths& paths)
{
    for (const std::string& path : options.outputs) {
        if (isFilm(path)) paths.writes(path);
        else paths.writesFrames(FrameNames::of(path));
    }
    for (const auto& exporter : exporters) {
        if (exporter->needs().views) exporter->setViews(viewsOf(scene, options));
        exporter->addPaths(scene, paths);
    }
    for (const std::string& path : {options.stats, options.record.states, options.record.last})
        if (!path.empty()) paths.writes(path);
}

void tellLeftOut(const Exporters& exporters, const World& world)
{
    for (const auto& exporter : exporters) {
        const std::vector<std::string> names = exporter->leftOut(world);
        if (names.empty()) continue;
        tellUser(fmt::format("knuckle: note: {} leaves out {}", exporter->path(), fmt::join(names, ", ")));
    }
}

uint64_t lastMissing(const Scene& scene, const FilmOptions& options, const FrameRange& range)
{
    if (!options.skipExisting || !options.stats.empty() || options.record.any() || options.hash ||
        std::ranges::any_of(options.outputs, isFilm))
        return range.last;
    uint64_t missing = 0;
    for (const std::string& path : options.outputs) {
        ExistingPictures there(FrameNames::of(path), scene.render.width, scene.render.height);
        for (uint64_t index = range.count(); index-- > 0;) {
            const uint64_t frame = range.first + index * range.stride;
            if (frame <= missing || !there.has(frame)) {
                missing = std::max(missing, frame);
                break;
            }
        }
    }
    return missing;
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
    if (scene.render.background == Background::Transparent && (isFilm(path) || FrameNames::of(path).areJpeg()))
        throw InputError(
            fmt::format("-o {}: has no alpha, and render.background is \"transparent\"; write PNG, or --set "
                        "render.background=sky",
                        path));
    if (!isFilm(path)) {
        const FrameNames names = FrameNames::of(path);
        if (names.digits == 0 && range.count() > 1)
            throw InputError(fmt::format("-o {}: names one picture, and there are {} frames; name them {}_####{}, or "
                                         "choose one by --frames",
                                         path, range.count(), path.substr(0, path.size() - names.after.size()),
                                         names.after));
        hasLabels_ = hasLabels_ || !names.areJpeg();
        PictureKeep* keep = checkpoint != nullptr ? checkpoint->pictures(output, names) : nullptr;
        if (options.skipExisting)
            keep = existing
                       .emplace_back(
                           std::make_unique<ExistingPictures>(names, scene.render.width, scene.render.height, keep))
                       .get();
        return pictureSink(names, keep, options.quality, options.depth);
    }
    const double rate = scene.framesPerSecond / static_cast<double>(range.stride);
    return filmSink(
        path, {scene.render.width, scene.render.height, rate, options.codec, options.pipe},
        {range.first, range.lastDrawn(), range.stride, checkpoint != nullptr ? checkpoint->film(output) : nullptr});
}

bool FilmOutputs::wantsPicture(uint64_t frame) const
{
    return std::ranges::any_of(sinks, [&](const auto& sink) { return sink->wants(frame); });
}

}  // namespace knuckle
