#include <CLI/CLI.hpp>
#include <memory>

#include "app/commands/command_options.h"
#include "app/commands/commands.h"
#include "app/commands/voxelize/voxelize_models.h"
#include "app/files/actor_check.h"

namespace knuckle {

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
        "that; a model without a skeleton has particles of 3 % of its longest side.\n"
        "Of several models, or of those in a folder, a line each is printed; -o and --preview are folders then, for\n"
        "NAME.actor.json and NAME.png. What cannot be read does not keep the others back; the exit code is 2.\n"
        "In folders those are read that end in\n" +
        modelEndings() +
        ".\n\n"
        "Examples:\n"
        "  knuckle voxelize model.glb                               print the table only\n"
        "  knuckle voxelize model.glb -o actor.json --particles 3000 --preview actor.png\n"
        "  knuckle voxelize model.glb -o figure.npz                 the same in arrays, with skin weights, for "
        "numpy.load\n"
        "  knuckle voxelize model.glb -o figure.urdf                bodies with masses, joints with limits, capsules\n"
        "  knuckle voxelize model.glb -o figure.json --levels 300,1000,4000   figure-300.json ..., with the same "
        "bodies\n"
        "  knuckle voxelize models/*.glb -o actors/ --jobs 2        each into actors/, and a line for each\n"
        "  knuckle voxelize model.glb --keep '*tail*' --merge 'hair*'   * is any part of a name, ? any letter\n"
        "  knuckle voxelize pair.fbx --skeleton Hips                one of two figures; without, their names are told\n"
        "  knuckle voxelize crates.obj --split                      parts that fall apart\n"
        "  knuckle schema joints                                    the format of --joints");
    auto options = std::make_shared<VoxelizeOptions>();
    command->add_option("MODEL", options->models, "The rigged model; several, or folders of them: each by itself")
        ->required();
    command
        ->add_option("-o,--output", options->output,
                     "Write the actor here, as arrays of NumPy as .npz, for simulators of robots as .urdf or .mjcf; - "
                     "is standard "
                     "output; of several models a folder")
        ->type_name("actor.json");
    auto* diameter = command->add_option("--diameter", options->diameter, "Diameter of a particle [m]")
                         ->check(numberBetween(SMALLEST_DIAMETER, 10.0))
                         ->type_name("M");
    command->add_option("--particles", options->particles, "As many particles as this, or nearly")
        ->check(CLI::Range(FEWEST_PARTICLES, MOST_PARTICLES))
        ->type_name("N")
        ->excludes(diameter);
    command
        ->add_option("--levels", options->levels,
                     "An actor for each of these numbers of particles, all with the bodies and joints of the coarsest: "
                     "actor-300.json, actor-1000.json")
        ->check(CLI::Range(FEWEST_PARTICLES, MOST_PARTICLES))
        ->type_name("N,N,...")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->excludes(diameter)
        ->excludes("--particles");
    command->add_option("--jobs", options->jobs, "So many models at once")
        ->check(CLI::Range(1u, 64u))
        ->capture_default_str()
        ->type_name("N");
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
    command->add_flag("--skin", options->skin,
                      "Write the mesh with the weights of its vertices and of particles as well; .npz always has them");
    command
        ->add_option("--preview", options->preview,
                     "Draw the actor from front and side: particles under its skin, joints with their limits; "
                     "of several models a folder")
        ->type_name("actor.png");
    command->callback([=] { line.chosen = [=] { return voxelizeModels(*options, line.common); }; });
}

}  // namespace knuckle
