#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <optional>
#include <set>
#include <utility>

#include "app/commands/command_options.h"
#include "app/commands/commands.h"
#include "app/commands/render_options.h"
#include "app/export/exporters.h"
#include "app/files/assets.h"
#include "app/film/complete_picture.h"
#include "app/film/film_outputs.h"
#include "app/film/replay.h"
#include "app/json/enum_words.h"
#include "app/run/progress.h"
#include "app/run/tell.h"
#include "render/output/film_kinds.h"
#include "sim/base/errors.h"
#include "sim/base/files/endings.h"

namespace knuckle {

namespace {

constexpr double DEFAULT_CHECKPOINT_SECONDS = 30.0;

/// @param folder in which it is; several scenes have one.
std::string defaultOutput(const Scene& scene, const std::string& base)
{
    std::string name = scene.name;
    std::replace(name.begin(), name.end(), '/', '_');
    const std::string folder = base + "/" + (name.starts_with('.') ? "scene" + name : name);
    return endingOf(folder).empty() ? folder : folder + "/";  // always a folder, whatever its name
}

/// @throws InputError for outputs that would overwrite inputs or each other.
void requireOwnPaths(const RenderOptions& options, const std::string& file, const Scene& scene, const FilmOptions& film,
                     const Exporters& exporters, const CommonOptions& common)
{
    RunPaths paths;
    paths.reads(file);
    if (!options.from.empty()) paths.reads(options.from);
    for (const std::string& named : scene.files) paths.readsModel(named);
    if (!common.shaderFolder.empty()) paths.readsFolder(common.shaderFolder);
    addOutputs(film, exporters, scene, paths);
    paths.check();
}

/// @throws InputError.
CheckpointOptions checkpointOptions(const RenderOptions& options)
{
    CheckpointOptions checkpoint = options.film.checkpoint;
    checkpoint.resume = !options.resume.empty();
    checkpoint.loose = options.resume == "loose";
    if (checkpoint.resume && !checkpoint.loose && options.resume != "strict")
        throw InputError(fmt::format("--resume={}: must be --resume or --resume=loose", options.resume));
    if (checkpoint.resume && !checkpoint.seconds) checkpoint.seconds = DEFAULT_CHECKPOINT_SECONDS;
    return checkpoint;
}

/// Tells the checkpoint which outputs the run has. @throws InputError for an output that no later run can go on with.
void nameOutputs(FilmOptions& film, const RenderOptions& options, const Scene& scene)
{
    std::vector<std::string>& words = film.checkpoint.words;
    const auto add = [&](const std::string& option, const std::string& value) {
        if (!value.empty()) words.push_back(option + " " + value);
    };
    for (size_t k = 0; k < film.outputs.size(); ++k) {
        const std::string& path = film.outputs[k];
        if (OutputPlace::of(path).kind == OutputPlace::Kind::Stream)
            throw InputError(fmt::format("--checkpoint: -o {} is a stream, with which no later run can go on; name a "
                                         "file or a folder",
                                         path));
        const std::string camera = k < film.cameras.size() ? film.cameras[k] : "";
        if (camera.empty()) add("-o", path);
        else add("--camera", camera + "=" + path);
        film.checkpoint.folders.push_back(isFilm(path) ? folderOf(OutputPlace::of(path).path)
                                                       : FrameNames::of(path).folder);
    }
    for (const std::string& word : options.exports) {
        add("--export", word);
        const OutputPlace place = OutputPlace::of(word.substr(word.find('=') + 1));
        film.checkpoint.folders.push_back(place.kind == OutputPlace::Kind::Folder ? place.path : folderOf(place.path));
    }
    for (const std::string& path : {film.record.states, film.record.last})
        if (!path.empty()) film.checkpoint.folders.push_back(folderOf(OutputPlace::of(path).path));
    for (const std::string& text : options.captions) add("--caption", text);
    add("--labels", options.labels);
    if (film.depth != 8) add("--depth", std::to_string(film.depth));
    add("--codec", film.codec);
    add("--record states=", film.record.states);
    if (film.record.every > 0) add("--record-every", std::to_string(film.record.every));
    add("--save-state", film.record.last);
    add("--size", fmt::format("{}x{}", scene.render.width, scene.render.height));
    if (film.frames.stride > 1) add("--stride", std::to_string(film.frames.stride));
    if (film.quality != DEFAULT_QUALITY) add("--quality", std::to_string(film.quality));
    const std::string first = std::to_string(std::max<uint64_t>(film.frames.first, 1));
    add("--frames", film.frames.onlyLast ? "last" : first + ":");
}

/// Where a scene without an output of its own goes.
constexpr const char* OUT = "out";

/// @param taken default outputs of the scenes before it.
int renderScene(const RenderOptions& options, const CommonOptions& common, std::set<std::string>& taken)
{
    FilmOptions film = options.film;
    std::vector<Override> overrides = overridesOf(options);
    film.quality = jpegQuality(options.quality);
    if (!options.frames.empty()) film.frames = FrameRange::parse(options.frames);
    film.frames.stride = options.stride;
    Exporters exporters = makeExporters(options.exports);
    const bool several = options.scenes.size() > 1;
    if (!several) addOutputs(film, options);
    film.record = recordOptions(options);
    film.checkpoint = checkpointOptions(options);
    checkOptions(options, film);
    if (options.preview && (!options.from.empty() || film.checkpoint.seconds || film.record.any()))
        throw InputError(
            "--preview: is no run to keep; leave out --from, --record, --save-state, --checkpoint and --resume");
    std::optional<StatesFile> states;
    std::string named = options.scene;
    if (!options.from.empty()) states.emplace(options.from);
    if (states && named.empty()) {
        const SceneSource& source = states->facts().source;
        named = source.file;
        overrides.insert(overrides.begin(), source.changes.begin(), source.changes.end());
    }
    film.source = {named, overrides};
    const std::string file = findAsset(named);
    Scene scene = loadScene(file, overrides, needsOf(exporters).surfaces);
    std::optional<Preview> preview;
    if (options.preview) {
        preview = previewOf(scene, [&](const std::vector<Override>& more) {
            std::vector<Override> all = overrides;
            all.insert(all.end(), more.begin(), more.end());
            return loadScene(file, all, needsOf(exporters).surfaces);
        });
        scene = preview->scene;
        film.frames.stride = std::max(film.frames.stride, preview->stride);
    }
    completePicture(scene);
    changePicture(scene, options, film);
    if (!common.quiet)
        for (const std::string& warning : scene.warnings)
            tellUser(fmt::format("knuckle: warning: {}: {}", named, warning));
    if (!exporters.empty() && !scene.clock.isEven())
        throw InputError("--export: shots of another `timeScale` than 1 show moments that are no frames of the "
                         "simulation; export without them: --set 'shots=[]'");
    const std::unique_ptr<Branch> branch = states ? nullptr : openBranch(scene);
    film.branch = branch.get();
    if (film.outputs.empty()) {
        const bool given = several && !options.outputs.empty();
        film.outputs.push_back(defaultOutput(scene, given ? options.outputs[0] : OUT));
        if (!taken.insert(film.outputs[0]).second)
            throw InputError(fmt::format("{}: goes into {}, as another one of the scenes; give it another \"name\"",
                                         named, film.outputs[0]));
    }
    if (film.checkpoint.seconds) nameOutputs(film, options, scene);
    requireOwnPaths(options, file, scene, film, exporters, common);
    if (states) replayFilm(*states, scene, film, common, std::move(exporters));
    else {
        const RunFigures figures = runFilm(scene, film, common, std::move(exporters));
        if (preview && !common.quiet)
            fmt::print("preview of {} particles for {}; an estimate: the real film takes {} here\n",
                       scene.world.particles.size(), preview->particles,
                       durationText(estimatedSeconds(*preview, figures, options.stride)));
    }
    return EXIT_FINE;
}

/// Each into its own output; what fails does not keep the others back. @returns the first failure's exit code.
int renderScenes(const RenderOptions& options, const CommonOptions& common)
{
    requireOneScene(options);
    RenderOptions one = options;
    std::set<std::string> taken;
    if (options.scenes.size() == 1) one.scene = options.scenes[0];
    if (options.scenes.size() < 2) return renderScene(one, common, taken);
    int code = EXIT_FINE;
    for (const std::string& scene : options.scenes) {
        one.scene = scene;
        try {
            renderScene(one, common, taken);
        } catch (...) {
            const int failed = tellFailure(std::current_exception());
            if (failed == EXIT_INTERRUPTED) return failed;
            if (code == EXIT_FINE) code = failed;
        }
    }
    return code;
}

}  // namespace

void addRenderCommand(CommandLine line)
{
    auto* command = line.program.add_subcommand("render", "Simulate a scene and write its frames or a film");
    command->fallthrough();
    command->footer(renderNotes());
    auto options = std::make_shared<RenderOptions>();
    command->add_option("SCENE", options->scenes, "Scene files, see docs/scene.md; several: each into its own folder");
    // One value per option, so that the scene may follow it.
    using Words = std::vector<std::string>;
    const auto list = [command](const char* name, Words& values, const std::string& words, const char* type) {
        command->add_option(name, values, words)->type_name(type)->take_all()->allow_extra_args(false);
    };
    list("-o,--output", options->outputs,
         "A folder for PNG frames, names for them as 'DIR/name_####.png' (or .jpg, .exr), a film ending in " +
             choiceOf(FILM_ENDINGS) + ", or - for one on standard output [out/NAME]",
         "DIR|film.mp4");
    command
        ->add_option("--codec", options->film.codec,
                     "Of films: h264, h265, av1 (.mov has none of it), of .webm vp9 or av1 [the first]")
        ->type_name("NAME")
        ->check(offered(codecWords()));
    command
        ->add_option("--quality", options->quality,
                     "How much work a frame is: draft, good or final [the scene's]; a number: of JPEG, 1 to 100 [92]")
        ->type_name("WORD|N")
        ->check(offered(EnumWords<Quality>::WORDS));
    command
        ->add_option("--pipe", options->film.pipe,
                     "What goes into a stream, as -o -: a film (mp4, mkv, webm), or frames as they are (y4m, raw: RGB "
                     "of 8 bits) [by the name's ending, else mp4]")
        ->type_name("KIND")
        ->check(offered(PIPE_WORDS));
    command->add_option("--frames", options->frames, "First and last frame to draw, or last [all]")
        ->type_name("A:B|last");
    command
        ->add_option("--stride", options->stride,
                     "Draw every Nth of these frames; a film of them has N times fewer a second [1]")
        ->type_name("N")
        ->check(numberBetween(1.0, 1e6));
    command->add_flag("--skip-existing", options->film.skipExisting,
                      "Leave pictures that are there, whole and of the same size; simulate only up to the last that is "
                      "missing");
    command->add_option("--depth", options->film.depth, "Bits of a channel of PNG frames, 8 or 16 [8]")->type_name("N");
    list("--caption", options->captions, "Write this at the bottom of the picture", "TEXT");
    command
        ->add_option("--labels", options->labels,
                     "Write these as well: frame, time, scaleBar, colorBar, with commas between them [the scene's]")
        ->type_name("LIST");
    command->add_option("--size", options->size, "Pixels of a frame [the scene's, 1280x720]")->type_name("WxH");
    command->add_option("--fps", options->framesPerSecond, "Frames per second, as 30 or 24000/1001 [the scene's, 60]")
        ->type_name("N");
    list("--camera", options->cameras,
         "Film everything by this one of the scene's cameras, or by auto, which sees all that moves [as its shots "
         "say]; with an output, as often as wanted: one more film of the same run, by this camera",
         "NAME|NAME=OUTPUT");
    command->add_flag("--preview", options->preview,
                      "A rough film in a fraction of the time: larger particles where the scene allows them, a small "
                      "picture, 12 frames a second; then an estimate of the time for the real one");
    command->add_flag("--turntable", options->turntable, "Go once around everything, in the whole film");
    list("--set", options->sets,
         "Change a field of the scene, as solver.substeps=8, or /solver/substeps=8 as errors tell it", "PATH=VALUE");
    command->add_option("--stats", options->film.stats, "Write figures of the run")->type_name("FILE");
    list("--export", options->exports, "Write particles, bodies or measures of each frame", "KIND=PATH");
    command
        ->add_option("--from", options->from,
                     "Draw frames of this file of states, without simulating; SCENE, if given, says how")
        ->type_name("FILE.states");
    list("--record", options->records, "Write what is drawn of each frame, and whole states, to go on or draw from",
         "states=FILE.states");
    command
        ->add_option("--record-every", options->film.record.every,
                     "Frames from one whole state to the next [those of a second]")
        ->type_name("N")
        ->check(numberBetween(1.0, 1e6));
    command->add_option("--save-state", options->film.record.last, "Write the last frame and its whole state")
        ->type_name("FILE.states");
    command
        ->add_option("--checkpoint", options->film.checkpoint.seconds,
                     "Write a checkpoint after as many seconds, and when stopped, into OUTPUT.checkpoint")
        ->type_name("SECONDS")
        ->check(numberBetween(0.0, 1e6));
    command->add_flag("--resume{strict}", options->resume,
                      "Go on from the checkpoint of an earlier run of the same command, if there is one; "
                      "--resume=loose: also on another driver or with another version, with other bits");
    command->add_flag("--hash", options->film.hash, "Print the hash of the last state");
    command->callback([=] { line.chosen = [=] { return renderScenes(*options, line.common); }; });
}

}  // namespace knuckle
