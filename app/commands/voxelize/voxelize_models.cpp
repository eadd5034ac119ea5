#include "app/commands/voxelize/voxelize_models.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <exception>
#include <filesystem>
#include <map>
#include <set>

#include "app/commands/commands.h"
#include "app/files/actor_file.h"
#include "app/files/assets.h"
#include "app/files/files_below.h"
#include "app/files/run_paths.h"
#include "render/compare/parallel.h"
#include "sim/base/errors.h"
#include "sim/base/files/endings.h"
#include "sim/base/files/output_place.h"

namespace knuckle {

namespace {

namespace fs = std::filesystem;

/// A .md5anim beside a .md5mesh is a part of that.
constexpr std::array ENDINGS{".glb", ".gltf", ".fbx", ".dae", ".bvh", ".obj",   ".ply",
                             ".stl", ".off",  ".3ds", ".x",   ".b3d", ".blend", ".md5mesh"};

/// A model and what is written of it, and what became of it.
struct Work {
    std::string model;
    std::vector<VoxelizeFiles> levels;
    std::vector<Actor> actors;
    std::exception_ptr failure;
};

/// The models named, and those in folders that are.
std::vector<std::string> modelsOf(const std::vector<std::string>& named)
{
    std::vector<std::string> models;
    std::error_code error;
    for (const std::string& given : named) {
        const std::string path = findAsset(given);
        std::vector<std::string> found;
        if (!fs::is_directory(path, error)) found.push_back(path);
        else
            for (const std::string& file : filesBelow(path))
                if (std::ranges::count(ENDINGS, endingOf(file)) > 0) found.push_back((fs::path(path) / file).string());
        for (const std::string& model : found)
            if (std::ranges::count(models, model) == 0) models.push_back(model);
        if (found.empty())
            throw InputError(fmt::format("{}: no model is in this folder; one ends in {}", given, modelEndings()));
    }
    return models;
}

/// @throws InputError for outputs that would overwrite inputs or each other.
void requireOwnPaths(const std::vector<Work>& all, const VoxelizeOptions& options)
{
    RunPaths paths;
    if (!options.joints.empty()) paths.reads(options.joints);
    for (const Work& work : all) {
        paths.readsModel(work.model);
        for (const VoxelizeFiles& files : work.levels)
            for (const std::string& path : {files.actor, files.preview})
                if (!path.empty()) paths.writes(path);
    }
    paths.check();
}

std::string fileIn(const std::string& folder, const std::string& model, const char* ending)
{
    return folder.empty() ? "" : (fs::path(folder) / fs::path(model).stem()).string() + ending;
}

/// figure.actor.json becomes figure-300.actor.json.
std::string ofLevel(const std::string& path, uint32_t particles)
{
    if (path.empty()) return path;
    fs::path name = fs::path(path).filename();
    std::string endings;
    while (!endingOf(name.string()).empty() && (endings.empty() || name.extension() == ".actor")) {
        endings = name.extension().string() + endings;
        name = name.stem();
    }
    return fs::path(path).replace_filename(fmt::format("{}-{}{}", name.string(), particles, endings)).string();
}

/// What is written of a model at each resolution, the coarsest first.
std::vector<VoxelizeFiles> levelsOf(const VoxelizeOptions& options, const std::string& actor,
                                    const std::string& preview)
{
    std::vector<VoxelizeFiles> levels;
    for (const uint32_t particles : std::set<uint32_t>(options.levels.begin(), options.levels.end()))
        levels.push_back({ofLevel(actor, particles), ofLevel(preview, particles), particles});
    if (levels.empty()) levels.push_back({actor, preview, options.particles});
    return levels;
}

/// What is wrong, without the model's name.
std::string errorOf(const Work& work)
{
    try {
        std::rethrow_exception(work.failure);
    } catch (const std::exception& error) {
        const std::string text = error.what(), start = work.model + ": ";
        return text.starts_with(start) ? text.substr(start.size()) : text;
    }
}

void printTable(const std::vector<Work>& all)
{
    const auto nameOf = [](const Work& work, size_t level) {
        const uint32_t particles = work.levels[level].particles;
        return work.levels.size() == 1 ? work.model : fmt::format("{} {}", work.model, particles);
    };
    size_t width = 0;
    for (const Work& work : all)
        for (size_t k = 0; k < work.levels.size(); ++k) width = std::max(width, nameOf(work, k).size());
    fmt::print("{:<{}}  particles  diameter, m  bodies  joints\n", "model", width);
    for (const Work& work : all) {
        if (work.failure) fmt::print("{:<{}}  failed: {}\n", work.model, width, errorOf(work));
        for (size_t k = 0; k < work.actors.size(); ++k) {
            const Actor& actor = work.actors[k];
            fmt::print("{:<{}}  {:>9}  {:>11.4g}  {:>6}  {:>6}\n", nameOf(work, k), width, actor.particles.size(),
                       actor.diameter, actor.bodies.size(), actor.joints.size());
        }
    }
}

/// What becomes of each, into folders, under its own name. Only the first model of a name is written.
std::vector<Work> plannedWork(const std::vector<std::string>& models, const VoxelizeOptions& options)
{
    const bool writes = !options.output.empty() || !options.preview.empty();
    std::map<std::string, std::string> namedBy;
    std::vector<Work> all;
    for (const std::string& model : models) {
        const std::string name = writes ? fs::path(model).stem().string() : model;
        Work& work = all.emplace_back(Work{model, {}, {}, {}});
        if (const auto [first, isNew] = namedBy.try_emplace(name, model); !isNew)
            work.failure = std::make_exception_ptr(InputError(
                fmt::format("{}: has the name of {}; rename one, or voxelize it alone", model, first->second)));
        else
            work.levels = levelsOf(options, fileIn(options.output, model, ".actor.json"),
                                   fileIn(options.preview, model, ".png"));
    }
    return all;
}

int voxelizeSeveral(const std::vector<std::string>& models, const VoxelizeOptions& options, const CommonOptions& common)
{
    for (const auto& [option, folder] : {std::pair{"-o ", options.output}, std::pair{"--preview ", options.preview}})
        if (!folder.empty()) requireFolder(option, folder, "several models");
    std::vector<Work> all = plannedWork(models, options);
    requireOwnPaths(all, options);
    forEachParallel(all.size(), options.jobs, [&](size_t i) {
        try {
            if (!all[i].failure) all[i].actors = voxelizeModel(all[i].model, all[i].levels, options, common, false);
        } catch (...) {
            all[i].failure = std::current_exception();
        }
    });
    int code = EXIT_FINE;
    for (const Work& work : all) {
        const int failure = work.failure ? tellFailure(work.failure) : EXIT_FINE;
        if (code == EXIT_FINE) code = failure;
    }
    if (!common.quiet) printTable(all);
    return code;
}

}  // namespace

std::string modelEndings()
{
    return fmt::format("{}", fmt::join(ENDINGS, " "));
}

int voxelizeModels(const VoxelizeOptions& options, const CommonOptions& common)
{
    const std::vector<std::string> models = modelsOf(options.models);
    const bool folder = options.output.ends_with('/') || options.preview.ends_with('/');
    if (models.size() > 1 || folder || models[0] != findAsset(options.models[0]))
        return voxelizeSeveral(models, options, common);
    if (!options.output.empty()) requireEnding("-o ", options.output, "an actor", actorEndings());
    if (!options.preview.empty()) requireEnding("--preview ", options.preview, "a picture", {".png"});
    if (!options.levels.empty() && !options.output.empty() &&
        OutputPlace::of(options.output).kind == OutputPlace::Kind::Stream)
        throw InputError(fmt::format("-o {}: levels are a file each; name one, as in -o actor.json", options.output));
    std::vector<Work> all{{models[0], levelsOf(options, options.output, options.preview), {}, {}}};
    requireOwnPaths(all, options);
    all[0].actors = voxelizeModel(models[0], all[0].levels, options, common, !common.quiet);
    if (!common.quiet && !options.levels.empty()) {
        fmt::print("\n");
        printTable(all);
    }
    return EXIT_FINE;
}

}  // namespace knuckle
