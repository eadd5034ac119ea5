#include "app/commands/voxelize/voxelize_model.h"

#include <fmt/format.h>

#include <list>
#include <mutex>
#include <optional>

#include "app/commands/voxelize/actor_preview.h"
#include "app/commands/voxelize/actor_table.h"
#include "app/files/actor_file.h"
#include "app/files/actor_levels.h"
#include "app/files/joints_file.h"
#include "sim/base/errors.h"
#include "sim/base/files/endings.h"
#include "sim/base/files/output_file.h"
#include "sim/rig/bodies/bone_options.h"
#include "sim/rig/import/import.h"
#include "sim/rig/limbs/fill_error.h"
#include "sim/rig/skin/actor_skin.h"

namespace knuckle {

namespace {

/// Reading forks, and drawing has a device: by one thread at a time.
std::mutex& oneAtATime()
{
    static std::mutex mutex;
    return mutex;
}

Model readModel(const std::string& path, const VoxelizeOptions& options, ImportOptions& import)
{
    import.fit = options.fit;
    import.fit.up = options.up == "z" ? UpAxis::Z : UpAxis::Y;
    import.fit.centering = options.center ? Centering::Always : Centering::WhereFar;
    import.surface = true;  // to note looks that cannot be read
    import.pick = {options.skeleton, options.split};
    try {
        const std::lock_guard lock(oneAtATime());
        return importModel(path, import);
    } catch (const SkeletonError& error) {
        throw InputError(
            fmt::format("{}; choose one by --skeleton NAME, or all as one by --skeleton '*'", error.what()));
    }
}

ActorOptions actorOptionsOf(const VoxelizeOptions& options)
{
    ActorOptions actor;
    actor.voxels.diameter = static_cast<float>(options.diameter);
    actor.alongBones = !options.grid;
    actor.articulation.keep = options.keep;
    actor.articulation.merge = options.merge;
    if (!options.joints.empty()) readJoints(options.joints, actor.articulation);
    return actor;
}

/// The files of a level, opened before any work.
struct OpenedFiles {
    std::optional<OutputFile> actor, preview;

    explicit OpenedFiles(const VoxelizeFiles& files)
    {
        if (!files.actor.empty()) actor.emplace(files.actor);
        if (!files.preview.empty()) preview.emplace(files.preview);
    }
};

}  // namespace

std::vector<Actor> voxelizeModel(const std::string& path, const std::vector<VoxelizeFiles>& levels,
                                 const VoxelizeOptions& options, const CommonOptions& common, bool prints)
{
    std::list<OpenedFiles> opened;
    for (const VoxelizeFiles& files : levels) opened.emplace_back(files);
    const ActorOptions actorOptions = actorOptionsOf(options);
    ImportOptions import;
    const Model model = readModel(path, options, import);
    const Figure figure = readFigure(model, rolesWanted(model, actorOptions.articulation));
    std::vector<uint32_t> counts;
    for (const VoxelizeFiles& level : levels) counts.push_back(level.particles);
    std::vector<Actor> actors = actorsOfLevels(path, figure, counts, actorOptions);
    if (prints) {
        const FillError error = fillError(actors.front(), Solid(model.vertices, model.triangles));
        fmt::print("{}", actorTable(actors.front(), figure, actorOptions.articulation, error));
    }
    auto files = opened.begin();
    for (size_t k = 0; k < levels.size(); ++k, ++files) {
        Actor& actor = actors[k];
        actor.model = {path, import.fit, import.pick};
        if (options.skin || endingOf(levels[k].actor) == ".npz") actor.skin = makeActorSkin(actor, model);
        if (files->actor) writeActor(*files->actor, levels[k].actor, actor);
        if (!files->preview) continue;
        const std::lock_guard lock(oneAtATime());
        files->preview->write(pngOf(drawPreview(actor, figure, common)));
        files->preview->commit();
    }
    return actors;
}

}  // namespace knuckle
