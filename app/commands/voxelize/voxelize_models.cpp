#include "app/commands/voxelize/voxelize_models.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <exception>
#include <filesystem>
#include <map>

#include "app/commands/commands.h"
#include "app/files/actor_file.h"
#include "app/files/assets.h"
#include "app/files/files_below.h"
#include "app/files/run_paths.h"
#include "sim/base/errors.h"
#include "sim/base/files/endings.h"

namespace knuckle {

namespace {

namespace fs = std::filesystem;

/// A .md5anim beside a .md5mesh is a part of that.
constexpr std::array ENDINGS{".glb", ".gltf", ".fbx", ".dae", ".bvh", ".obj",   ".ply",
                             ".stl", ".off",  ".3ds", ".x",   ".b3d", ".blend", ".md5mesh"};

/// What became of a model, for the table.
struct Outcome {
    std::string model, error;
    size_t particles = 0, bodies = 0, joints = 0;
    float diameter = 0.0f;
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
void requireOwnPaths(const std::vector<VoxelizeFiles>& all, const VoxelizeOptions& options)
{
    RunPaths paths;
    if (!options.joints.empty()) paths.reads(options.joints);
    for (const VoxelizeFiles& files : all) {
        paths.readsModel(files.model);
        for (const std::string& path : {files.actor, files.preview})
            if (!path.empty()) paths.writes(path);
    }
    paths.check();
}

std::string fileIn(const std::string& folder, const std::string& model, const char* ending)
{
    return folder.empty() ? "" : (fs::path(folder) / fs::path(model).stem()).string() + ending;
}

Outcome failed(const std::string& model, std::string error)
{
    if (error.starts_with(model + ": ")) error.erase(0, model.size() + 2);
    return {model, error};
}

void printTable(const std::vector<Outcome>& outcomes)
{
    size_t width = 0;
    for (const Outcome& outcome : outcomes) width = std::max(width, outcome.model.size());
    fmt::print("{:<{}}  particles  diameter, m  bodies  joints\n", "model", width);
    for (const Outcome& o : outcomes) {
        if (!o.error.empty()) fmt::print("{:<{}}  failed: {}\n", o.model, width, o.error);
        else
            fmt::print("{:<{}}  {:>9}  {:>11.4g}  {:>6}  {:>6}\n", o.model, width, o.particles, o.diameter, o.bodies,
                       o.joints);
    }
}

/// Each into folders, under its own name.
int voxelizeSeveral(const std::vector<std::string>& models, const VoxelizeOptions& options, const CommonOptions& common)
{
    for (const auto& [option, folder] : {std::pair{"-o ", options.output}, std::pair{"--preview ", options.preview}})
        if (!folder.empty()) requireFolder(option, folder, "several models");
    const bool writes = !options.output.empty() || !options.preview.empty();
    const auto nameOf = [&](const std::string& model) { return writes ? fs::path(model).stem().string() : model; };
    std::map<std::string, std::string> namedBy;  // only the first model of a name is written
    std::vector<VoxelizeFiles> all;
    for (const std::string& model : models)
        if (namedBy.try_emplace(nameOf(model), model).second)
            all.push_back(
                {model, fileIn(options.output, model, ".actor.json"), fileIn(options.preview, model, ".png")});
    requireOwnPaths(all, options);
    int code = EXIT_FINE;
    std::vector<Outcome> outcomes;
    auto next = all.begin();
    for (const std::string& model : models) {
        try {
            if (next == all.end() || next->model != model)
                throw InputError(fmt::format("{}: has the name of {}; rename one, or voxelize it alone", model,
                                             namedBy.at(nameOf(model))));
            const Actor actor = voxelizeModel(*next++, options, common, false);
            outcomes.push_back(
                {model, "", actor.particles.size(), actor.bodies.size(), actor.joints.size(), actor.diameter});
        } catch (const std::exception& error) {
            const int failure = tellFailure(std::current_exception());
            if (code == EXIT_FINE) code = failure;
            outcomes.push_back(failed(model, error.what()));
        }
    }
    if (!common.quiet) printTable(outcomes);
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
    const VoxelizeFiles files{models[0], options.output, options.preview};
    requireOwnPaths({files}, options);
    voxelizeModel(files, options, common, !common.quiet);
    return EXIT_FINE;
}

}  // namespace knuckle
