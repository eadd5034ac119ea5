#include "app/commands/voxelize/voxelize_model.h"

#include <fmt/format.h>

#include <optional>

#include "app/commands/voxelize/actor_preview.h"
#include "app/commands/voxelize/actor_table.h"
#include "app/files/actor_check.h"
#include "app/files/actor_file.h"
#include "app/files/joints_file.h"
#include "sim/base/errors.h"
#include "sim/base/files/endings.h"
#include "sim/base/files/output_file.h"
#include "sim/rig/bodies/bone_options.h"
#include "sim/rig/bodies/make_actor.h"
#include "sim/rig/import/import.h"
#include "sim/rig/limbs/fill_error.h"
#include "sim/rig/skin/actor_skin.h"

namespace knuckle {

namespace {

Model readModel(const std::string& path, const ImportOptions& options)
{
    try {
        return importModel(path, options);
    } catch (const SkeletonError& error) {
        throw InputError(
            fmt::format("{}; choose one by --skeleton NAME, or all as one by --skeleton '*'", error.what()));
    }
}

}  // namespace

Actor voxelizeModel(const VoxelizeFiles& files, const VoxelizeOptions& options, const CommonOptions& common,
                    bool prints)
{
    std::optional<OutputFile> output, preview;
    if (!files.actor.empty()) output.emplace(files.actor);
    if (!files.preview.empty()) preview.emplace(files.preview);
    ImportOptions import;
    import.fit = options.fit;
    import.fit.up = options.up == "z" ? UpAxis::Z : UpAxis::Y;
    import.fit.centering = options.center ? Centering::Always : Centering::WhereFar;
    import.surface = true;  // to note looks that cannot be read
    ActorOptions actorOptions;
    actorOptions.voxels.diameter = static_cast<float>(options.diameter);
    actorOptions.particleCount = options.particles;
    actorOptions.alongBones = !options.grid;
    actorOptions.articulation.keep = options.keep;
    actorOptions.articulation.merge = options.merge;
    if (!options.joints.empty()) readJoints(options.joints, actorOptions.articulation);
    import.pick = {options.skeleton, options.split};
    const Model model = readModel(files.model, import);
    const Figure figure = readFigure(model, rolesWanted(model, actorOptions.articulation));
    Actor actor = makeActor(figure, actorOptions);
    actor.model = {files.model, import.fit, import.pick};
    requireUsable(files.model, actor);
    if (prints) {
        const FillError error = fillError(actor, Solid(model.vertices, model.triangles));
        fmt::print("{}", actorTable(actor, figure, actorOptions.articulation, error));
    }
    if (options.skin || endingOf(files.actor) == ".npz") actor.skin = makeActorSkin(actor, model);
    if (output) writeActor(*output, files.actor, actor);
    if (preview) {
        preview->write(pngOf(drawPreview(actor, figure, common)));
        preview->commit();
    }
    return actor;
}

}  // namespace knuckle
