#include "app/film/replay.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "app/export/frame_export.h"
#include "app/film/film_outputs.h"
#include "app/run/counted.h"
#include "app/run/interrupt.h"
#include "app/run/progress.h"
#include "app/run/tell.h"
#include "app/states/picture_labels.h"
#include "render/quantities/color_scale.h"
#include "render/stored_view.h"
#include "sim/base/errors.h"
#include "sim/base/fnv_hash.h"
#include "sim/world/fingerprint/fingerprint.h"

namespace knuckle {

namespace {

void requireSameWorld(const StatesFile& states, const Scene& scene)
{
    const RunFacts& facts = states.facts();
    if (facts.fingerprint.world != hashText(fingerprint(scene.world)))
        throw InputError(
            fmt::format("{}: is of another world than this scene, made of {}: what is simulated must be "
                        "the same; leave SCENE out to take it as it was, and change its picture with --set",
                        states.path(), facts.source.file));
    if (facts.framesPerSecond != scene.framesPerSecond)
        throw InputError(fmt::format("{}: has {} frames a second, the scene {}; set fps={}", states.path(),
                                     facts.framesPerSecond, scene.framesPerSecond, facts.framesPerSecond));
    const FilmClock clock = facts.document.empty()
                                ? FilmClock(facts.framesPerSecond, facts.stepsPerFrame, {})
                                : storedClock(facts.source.file, facts.document, facts.stepsPerFrame);
    if (showsFluids(scene.render))
        throw InputError(fmt::format("{}: has no pressures and densities of fluids, which render.colorBy asks for; "
                                     "choose another, or render the scene",
                                     states.path()));
    const auto lacks = [&](const char* part) {
        return !states.blocks().has(frameBlock(states.frames().front(), part));
    };
    if ((scene.world.shown.ages && lacks(AGES)) || (scene.world.shown.contactForces && lacks(CONTACT_FORCES)))
        throw InputError(fmt::format("{}: has no {}, which render.colorBy asks for and only a run that shows them "
                                     "records; choose another, or render the scene",
                                     states.path(), scene.world.shown.ages ? "ages" : "forces of contacts"));
    if (clock != scene.clock)
        throw InputError(fmt::format("{}: its frames are of other moments than the scene's: give shots the `from` and "
                                     "`timeScale` of its run, and any camera",
                                     states.path()));
}

/// The file's frames among those wanted.
std::vector<uint64_t> chosenFrames(const StatesFile& states, const FrameRange& range)
{
    if (range.onlyLast && !states.frames().empty()) return {states.frames().back()};
    std::vector<uint64_t> chosen;
    for (const uint64_t frame : states.frames())
        if (frame >= range.first && (range.last == 0 || frame <= range.last)) chosen.push_back(frame);
    if (chosen.empty())
        throw InputError(states.frames().empty()
                             ? states.path() + ": has no frames to draw"
                             : fmt::format("--frames {}:{}: {} has frames {} to {}; choose among them",
                                           std::max<uint64_t>(range.first, 1), range.last, states.path(),
                                           states.frames().front(), states.frames().back()));
    return chosen;
}

}  // namespace

void replayFilm(const StatesFile& states, const Scene& scene, const FilmOptions& options, const CommonOptions& common,
                Exporters exporters)
{
    requireSameWorld(states, scene);
    if (scene.render.shutter > 0.0f)
        throw InputError(fmt::format("render.shutter: {} has no moments between frames to be exposed to; take --set "
                                     "render.shutter=0",
                                     states.path()));
    if (needsOf(exporters).measures)
        throw InputError(fmt::format("--export measures: {} does not hold what they are measured from; export them in "
                                     "the run that simulates",
                                     states.path()));
    if (needsOf(exporters).densities && scene.world.fluidCount > 0 && !common.quiet)
        tellUser("knuckle: note: exports leave out densities, which " + states.path() + " does not hold");
    const std::vector<uint64_t> frames = chosenFrames(states, options.frames);
    const FrameRange range{frames.front(), frames.back(), options.frames.stride};
    const std::vector<FilmView> views = viewsOf(scene, options);
    const FilmOutputs outputs(scene, options, range, std::move(exporters));
    const auto gpu = openGpu(common, FrameWork{{}, drawingWorkload(views)});
    const OpenExporters exporting(outputs.exporters, *gpu);
    StoredView stored(scene.world);
    const RunFacts facts = outputs.hasLabels() ? factsOf(scene, *gpu, options.source) : RunFacts();
    DrawingHere drawing(*gpu, scene, views, outputs.sinks, false);
    const uint64_t begin = states.frames().front();
    if (hasState(states.blocks(), begin) && haveSameCamera(scene, states.facts()))
        drawing.loadState(unpackState(states.blocks(), begin).cameras);
    const ViewCoding coding(scene.world);
    Progress progress("frame", frames.size(), common.quiet);
    const InterruptGuard interrupt;
    uint64_t done = 0;
    // A camera that follows has seen every frame before those that are drawn.
    for (const uint64_t frame : states.frames()) {
        if (frame > frames.back()) break;
        const bool wanted = frame >= frames.front();
        FrameRecord record{.number = frame, .view = coding.unpack(states.blocks(), frame)};
        const double time = scene.timeOf(frame);
        const bool drawn = range.has(frame) && outputs.wantsPicture(frame);
        const bool labelled = drawn && outputs.hasLabels();
        drawing.take(stored.upload(*record.view),
                     {frame, time, drawn, {}, labelled ? labelsOf(facts, frame, stateHash(*record.view)) : PngText()});
        if (!wanted) {
            passFrame(record, scene.world, outputs.exporters);
            continue;
        }
        exportFrame(record, scene.world, outputs.needs, outputs.exporters);
        drawing.fetch();
        interrupt.check();
        progress.update(++done);
    }
    for (const auto& sink : outputs.sinks) sink->finish();
    gpu->checkErrors();
    for (const auto& exporter : outputs.exporters) exporter->finish();
    if (!common.quiet)
        fmt::print("{} of {} drawn in {}: {}\n", counted(frames.size(), "frame"), states.path(),
                   durationText(progress.seconds()), fmt::join(options.outputs, ", "));
}

}  // namespace knuckle
