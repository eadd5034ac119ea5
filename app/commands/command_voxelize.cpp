#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <optional>

#include "app/commands/actor_preview.h"
#include "app/commands/actor_table.h"
#include "app/commands/command_options.h"
#include "app/commands/commands.h"
#include "app/files/actor_file.h"
#include "app/files/assets.h"
#include "app/files/joints_file.h"
#include "app/files/run_paths.h"
#include "app/run/counted.h"
#include "sim/base/errors.h"
#include "sim/base/files/endings.h"
#include "sim/base/files/output_file.h"
#include "sim/rig/bodies/bone_options.h"
#include "sim/rig/bodies/make_actor.h"
#include "sim/rig/import/import.h"
#include "sim/rig/limbs/fill_error.h"

namespace knuckle {

namespace {

constexpr uint32_t FEWEST_PARTICLES = 12, MOST_PARTICLES = 200000;
constexpr double SMALLEST_DIAMETER = 0.001;  // of a scene [m]

struct VoxelizeOptions {
    std::string model, output, joints, preview, skeleton;
    std::vector<std::string> keep, merge;
    double diameter = 0.0;
    uint32_t particles = 0;
    ModelFit fit;
    std::string up = "y";
    bool center = false;
    bool grid = false, split = false;
};

/// Checks that a scene can use it. @throws InputError, std::logic_error.
void requireUsable(const std::string& file, const Actor& actor)
{
    const size_t count = actor.particles.size();
    if (count < FEWEST_PARTICLES)
        throw InputError(fmt::format("{}: {} of {:.3g} m are too few for an actor; use --particles 1000, or a smaller "
                                     "--diameter",
                                     file, counted(count, "particle"), actor.diameter));
    if (actor.diameter < static_cast<float>(SMALLEST_DIAMETER))
        throw InputError(
            fmt::format("{}: it would consist of particles of {:.3g} m, scenes have some of {:g} m or more; "
                        "make it larger by --height, or use fewer --particles",
                        file, actor.diameter, SMALLEST_DIAMETER));
    WorldBuilder builder(0.5f * actor.diameter);
    addActor(builder, actor, builder.addMaterial({}), {});
    builder.build();
}

Model readModel(const std::string& path, const ImportOptions& options)
{
    try {
        return importModel(path, options);
    } catch (const SkeletonError& error) {
        throw InputError(
            fmt::format("{}; choose one by --skeleton NAME, or all as one by --skeleton '*'", error.what()));
    }
}

/// @throws InputError for outputs of the wrong kind, or that would overwrite inputs or each other.
void requireOwnPaths(const VoxelizeOptions& options)
{
    RunPaths paths;
    paths.readsModel(options.model);
    if (!options.joints.empty()) paths.reads(options.joints);
    if (!options.output.empty()) requireEnding("-o ", options.output, "an actor", {".json"});
    if (!options.preview.empty()) requireEnding("--preview ", options.preview, "a picture", {".png"});
    for (const std::string& path : {options.output, options.preview})
        if (!path.empty()) paths.writes(path);
    paths.check();
}

int voxelizeFile(VoxelizeOptions options, const CommonOptions& common)
{
    options.model = findAsset(options.model);
    requireOwnPaths(options);
    std::optional<OutputFile> output, preview;
    if (!options.output.empty()) output.emplace(options.output);
    if (!options.preview.empty()) preview.emplace(options.preview);
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
    const Model model = readModel(options.model, import);
    const Figure figure = readFigure(model, rolesWanted(model, actorOptions.articulation));
    Actor actor = makeActor(figure, actorOptions);
    actor.model = {options.model, import.fit, import.pick};
    requireUsable(options.model, actor);
    if (!common.quiet) {
        const FillError error = fillError(actor, Solid(model.vertices, model.triangles));
        fmt::print("{}", actorTable(actor, figure, actorOptions.articulation, error));
    }
    if (output) writeActor(*output, options.output, actor);
    if (preview) {
        preview->write(pngOf(drawPreview(actor, figure, common)));
        preview->commit();
    }
    return EXIT_FINE;
}

}  // namespace

void addVoxelizeCommand(CommandLine line)
{
    auto* command = line.program.add_subcommand("voxelize", "Fill a rigged model with particles, as a ragdoll");
    command->fallthrough();
    command->footer(
        "Reads glTF, FBX, Collada, BVH and what else assimp knows. Prints a table of the bodies, their particles, "
        "joints\n"
        "and how far these turn, what each bone was taken for and by what (its name, the skeleton's shape, clips,\n"
        "options); then the size, the pose, the clips that a scene can play, and which bones were merged and why.\n"
        "Without --diameter or --particles, limbs are two to three particles thick, as far as 800 to 4000 particles "
        "do\n"
        "that; a model without a skeleton has particles of 3 % of its longest side.\n\n"
        "Examples:\n"
        "  knuckle voxelize model.glb                               print the table only\n"
        "  knuckle voxelize model.glb -o actor.json --particles 3000 --preview actor.png\n"
        "  knuckle voxelize model.glb --keep '*tail*' --merge 'hair*'   * is any part of a name, ? any letter\n"
        "  knuckle voxelize pair.fbx --skeleton Hips                one of two figures; without, their names are told\n"
        "  knuckle voxelize crates.obj --split                      parts that fall apart\n"
        "  knuckle schema joints                                    the format of --joints");
    auto options = std::make_shared<VoxelizeOptions>();
    command->add_option("MODEL", options->model, "The rigged model")->required();
    command->add_option("-o,--output", options->output, "Write the actor here")->type_name("actor.json");
    auto* diameter = command->add_option("--diameter", options->diameter, "Diameter of a particle [m]")
                         ->check(numberBetween(SMALLEST_DIAMETER, 10.0))
                         ->type_name("M");
    command->add_option("--particles", options->particles, "As many particles as this, or nearly")
        ->check(CLI::Range(FEWEST_PARTICLES, MOST_PARTICLES))
        ->type_name("N")
        ->excludes(diameter);
    command
        ->add_option("--skeleton", options->skeleton,
                     "Of a file with several skeletons the one of this root bone, with its meshes and clips")
        ->type_name("PATTERN");
    auto* split = command->add_flag(
        "--split", options->split,
        "A rigid body, without a joint, for each separate part of a model without a skeleton");
    command->add_option("--joints", options->joints, "Joint types that override those from the bones' names")
        ->type_name("FILE")
        ->excludes(split);
    auto* height = command->add_option("--height", options->fit.height, "Height of the figure, instead of --scale [m]")
                       ->check(numberBetween(0.01, 100.0))
                       ->type_name("M");
    command
        ->add_option("--scale", options->fit.scale, "Metres per unit of the model; 0: as the file says, else guessed")
        ->check(numberBetween(0.0, 1e6))
        ->capture_default_str()
        ->type_name("M")
        ->excludes(height);
    command->add_option("--up", options->up, "The axis that points up, where the file does not say so")
        ->check(CLI::IsMember({"y", "z"}))
        ->type_name("y|z");
    command->add_flag("--center", options->center, "Lowest point at height 0, middle over the origin");
    const auto list = [command, split](const char* name, std::vector<std::string>& values, const char* words) {
        command->add_option(name, values, words)
            ->type_name("PATTERN ...")
            ->take_all()
            ->allow_extra_args(false)
            ->excludes(split);
    };
    list("--keep", options->keep, "Bones that get a body of their own where they are large enough");
    list("--merge", options->merge, "Bones that are part of the body that they hang on");
    command->add_flag("--grid", options->grid, "All particles on one grid, not those of a limb on one along its bone");
    command
        ->add_option("--preview", options->preview,
                     "Draw the actor from front and side: particles under its skin, joints with their limits")
        ->type_name("actor.png");
    command->callback([=] { line.chosen = [=] { return voxelizeFile(*options, line.common); }; });
}

}  // namespace knuckle
