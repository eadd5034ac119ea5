#include "app/commands/render_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "app/commands/command_options.h"
#include "app/export/exporters.h"
#include "app/film/film_outputs.h"
#include "app/film/film_views.h"
#include "sim/base/errors.h"
#include "sim/base/files/endings.h"
#include "sim/solver/workload.h"

namespace knuckle {

namespace {

constexpr double FEWER = 0.7;                            // share of the particles that a rough scene has at most
constexpr std::array PREVIEW_DIAMETERS{2.0, 1.5, 1.25};  // times that of the scene; the first that it can be made of
constexpr double PREVIEW_FRAMES = 12.0;                  // a second

Json labelsOf(const std::string& list)
{
    Json words = Json::array();
    for (size_t at = 0; at <= list.size();) {
        const size_t end = std::min(list.find(',', at), list.size());
        words.push_back(list.substr(at, end - at));
        at = end + 1;
    }
    return words;
}

/// Whether a --camera is of an output of its own.
bool namesOutput(const std::string& camera)
{
    return camera.find('=') != std::string::npos;
}

/// Estimated time of a frame's steps [ms].
double stepTime(const Scene& scene)
{
    constexpr double DISPATCH = 0.02;  // on one thread [ms]
    const Workload work = stepWorkload(scene.world) * scene.stepsPerFrame;
    return work.milliseconds + DISPATCH * work.dispatches;
}

constexpr const char* NOTES =
    "Frame 1 shows time 0. --frames 100:120 simulates up to frame 100 without drawing. -o may be given more than\n"
    "once, for frames and films of the same run; a film needs the program ffmpeg.\n"
    "Ctrl-C finishes the frame and stops: frames and PLY files are kept, films and other exports, which are not\n"
    "finished, are not. With --checkpoint 30 --resume the same command goes on from there, and from any other end.\n\n";

constexpr const char* MORE_NOTES =
    "--stats FILE                  JSON: device, passes with ms, particles, how deep contacts are, how far joints\n"
    "                              gape, density of fluids, strain of soft bodies, stretch of ropes and cloth, energy\n"
    "docs/output.md has every property, column and key.\n\n"
    "Examples:\n"
    "  knuckle render assets/scenes/hello.json --size 640x360\n"
    "  knuckle render assets/scenes/pile.json -o pile.mp4 --set solver.substeps=8 --stats pile.stats.json\n"
    "  knuckle render assets/scenes/ragdoll.json --turntable -o around.mp4\n"
    "  knuckle render assets/scenes/dance.json -o dance.gif --size 480x270 --stride 2\n"
    "  knuckle render assets/scenes/dance.json -o 'out/dance_####.jpg' --skip-existing\n"
    "  knuckle render assets/scenes/ragdoll.json --frames 100:120 --export ply=out/particles";

/// Of particles as large as the scene can be made of; of its own where that does not make them fewer.
Scene roughScene(const Scene& real, const std::vector<Override>& changes,
                 const std::function<Scene(const std::vector<Override>&)>& load)
{
    for (const double larger : PREVIEW_DIAMETERS) {
        std::vector<Override> coarse = changes;
        coarse.push_back({"diameter", larger * static_cast<double>(real.world.diameter())});
        try {
            Scene scene = load(coarse);
            const auto count = static_cast<double>(scene.world.particles.size());
            if (count <= FEWER * static_cast<double>(real.world.particles.size())) return scene;
            break;  // what is counted in particles would only be larger, and come too near to its neighbours
        } catch (const InputError&) {
            continue;  // something in it is too thin for particles so large
        }
    }
    return load(changes);
}

}  // namespace

std::string renderNotes()
{
    return NOTES + exportHelp() + MORE_NOTES;
}

std::vector<Override> overridesOf(const RenderOptions& options)
{
    std::vector<Override> overrides;
    for (const std::string& text : options.sets) overrides.push_back(parseOverride(text));
    // As two overrides, so that the schema checks the range.
    if (!options.size.empty()) {
        const auto [width, height] = parsePictureSize(options.size);
        overrides.push_back({"render.width", width});
        overrides.push_back({"render.height", height});
    }
    if (isQualityWord(options.quality)) overrides.push_back({"render.quality", options.quality});
    if (!options.labels.empty()) overrides.push_back({"render.labels", labelsOf(options.labels)});
    if (!options.framesPerSecond.empty())
        overrides.push_back(parseOverride("fps=" + options.framesPerSecond, "--fps "));
    std::vector<std::string> only = options.cameras;
    std::erase_if(only, namesOutput);
    if (only.size() > 1)
        throw InputError(fmt::format("--camera {0}, {1}: one films everything; give others an output of their own, as "
                                     "--camera {1}={1}.mp4",
                                     only[0], only[1]));
    if (!only.empty() && options.turntable) throw InputError("--turntable: is a camera of its own; leave out --camera");
    if (options.turntable) only = {"turntable"};
    if (!only.empty()) overrides.push_back({"render.camera", only[0]});
    return overrides;
}

RecordOptions recordOptions(const RenderOptions& options)
{
    RecordOptions record = options.film.record;
    if (options.records.size() > 1) throw InputError("--record: is given more than once; one file of states is enough");
    if (!options.records.empty()) record.states = parseRecord(options.records[0]);
    for (const auto& [option, path] : {std::pair{"--record states=", record.states}, {"--save-state ", record.last}})
        if (!path.empty()) requireEnding(option, path, "a file of states", {".states"});
    return record;
}

void addOutputs(FilmOptions& film, const RenderOptions& options)
{
    film.outputs = options.outputs;
    film.cameras.resize(film.outputs.size());
    for (const std::string& text : options.cameras) {
        if (!namesOutput(text)) continue;
        CameraOutput output = CameraOutput::parse(text);
        film.outputs.push_back(std::move(output.path));
        film.cameras.push_back(std::move(output.camera));
    }
}

void changePicture(Scene& scene, const RenderOptions& options, const FilmOptions& film)
{
    for (const std::string& text : options.captions) scene.render.overlay.captions.push_back({.text = text});
    if (options.film.depth != 8 && options.film.depth != 16)
        throw InputError(fmt::format("--depth {}: must be 8 or 16", options.film.depth));
    const bool isExr = std::ranges::any_of(
        film.outputs, [](const std::string& path) { return !isFilm(path) && FrameNames::of(path).areExr(); });
    if (isExr || options.film.depth == 16) scene.render.depth = 16;
}

Preview previewOf(const Scene& real, const std::function<Scene(const std::vector<Override>&)>& load)
{
    Preview preview{{}, 1, real.world.particles.size(), real.render.width, real.render.height};
    const auto smaller = [](uint32_t pixels) { return std::max(2 * (pixels / 6), 32u); };
    std::vector<Override> changes{{"render.width", smaller(preview.width)}, {"render.height", smaller(preview.height)}};
    preview.stride = static_cast<uint64_t>(std::max(1.0, std::round(real.framesPerSecond / PREVIEW_FRAMES)));
    preview.scene = roughScene(real, changes, load);
    preview.steps = stepTime(real) / stepTime(preview.scene);
    return preview;
}

double estimatedSeconds(const Preview& preview, const RunFigures& figures, uint64_t stride)
{
    const Scene& rough = preview.scene;
    const double pixels = static_cast<double>(preview.width) * preview.height /
                          (static_cast<double>(rough.render.width) * rough.render.height);
    const double frames = static_cast<double>(preview.stride) / static_cast<double>(stride);
    const double simulating = (figures.simulationSeconds - figures.warm.simulationSeconds) * preview.steps;
    const double drawing = (figures.drawing.seconds - figures.drawing.firstSeconds) * pixels * frames;
    // What goes on at once here does so in the real one.
    const double both = figures.driverThreads.drawAside ? std::max(simulating, drawing) : simulating + drawing;
    return figures.warm.totalSeconds + both;
}

void checkOptions(const RenderOptions& options, const FilmOptions& film)
{
    if (!film.stats.empty()) requireEnding("--stats ", film.stats, "a file of figures", {".json", ".txt", ""});
    checkOutputs(film);
    if (options.from.empty()) {
        if (options.scene.empty()) throw InputError("SCENE is required, or --from; see knuckle render --help");
        return;
    }
    if (film.record.any() || !film.stats.empty() || film.hash || film.checkpoint.seconds)
        throw InputError("--from: nothing is simulated, so there is nothing to record, to measure or to go on with; "
                         "leave out --record, --save-state, --stats, --hash, --checkpoint and --resume");
}

void requireOneScene(const RenderOptions& options)
{
    if (options.scenes.size() < 2) return;
    if (!options.exports.empty() || !options.records.empty() || !options.film.record.last.empty() ||
        !options.film.stats.empty() || !options.from.empty() || !options.resume.empty() ||
        options.film.checkpoint.seconds)
        throw InputError("several scenes: --export, --record, --save-state, --stats, --from, --checkpoint and --resume "
                         "are for one at a time; leave them out, or call knuckle for each");
    if (std::ranges::any_of(options.cameras, namesOutput))
        throw InputError("several scenes: --camera NAME=OUTPUT is for one at a time; give --camera NAME alone");
    if (options.outputs.size() > 1 ||
        (options.outputs.size() == 1 && (isFilm(options.outputs[0]) || FrameNames::areGivenBy(options.outputs[0]))))
        throw InputError(fmt::format("-o {}: several scenes want a folder, in which each gets one of its own",
                                     options.outputs.back()));
    for (size_t k = 0; k < options.scenes.size(); ++k)
        if (std::count(options.scenes.begin(), options.scenes.end(), options.scenes[k]) > 1)
            throw InputError(fmt::format("{}: is given twice; name each scene once", options.scenes[k]));
}

}  // namespace knuckle
