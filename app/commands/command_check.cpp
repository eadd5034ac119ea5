#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "app/branch/branch.h"
#include "app/commands/commands.h"
#include "app/files/actor_check.h"
#include "app/files/actor_file.h"
#include "app/files/assets.h"
#include "app/film/complete_picture.h"
#include "app/run/counted.h"
#include "app/run/tell.h"
#include "app/scene/scene_file.h"
#include "sim/base/errors.h"
#include "sim/solver/measure/animated_depths.h"

namespace knuckle {

namespace {

std::string sentenceOf(const World& world, const AnimatedDepth& deep)
{
    const std::string what = deep.other == NO_INDEX ? fmt::format("collider {}", deep.collider)
                                                    : fmt::format("\"{}\"", world.objects[deep.other].name);
    return fmt::format("the animation of \"{}\" goes {:.2f} m into {} at {:.2f} s, and passes through it",
                       world.objects[deep.object].name, deep.depth, what, deep.time);
}

/// "1726 particles, 18 bodies, 17 joints"
std::string contentsOf(const World& world)
{
    return fmt::format("{}, {}, {}", counted(world.particles.size(), "particle"),
                       counted(world.bodies.size(), "body", "bodies"), counted(jointCount(world), "joint"));
}

void checkScene(const std::string& path, const std::vector<Override>& overrides, bool quiet)
{
    Scene scene = loadScene(findAsset(path), overrides);
    completePicture(scene);
    const std::unique_ptr<Branch> branch = openBranch(scene);
    if (quiet) return;
    if (branch) fmt::print("{}: note: {}\n", path, branch->note());
    for (const std::string& note : scene.notes) fmt::print("{}: note: {}\n", path, note);
    for (const std::string& warning : scene.warnings) fmt::print("{}: warning: {}\n", path, warning);
    const World& world = scene.world;
    for (const AnimatedDepth& deep : animatedDepths(world, static_cast<float>(scene.simulatedSeconds())))
        fmt::print("{}: note: {}\n", path, sentenceOf(world, deep));
    fmt::print("{}: {}, {}, {:g} s ({})\n", path, contentsOf(world), counted(world.colliders.size(), "collider"),
               scene.duration, counted(scene.frameCount(), "frame"));
}

void checkActor(const std::string& path, const std::vector<Override>& overrides, bool quiet)
{
    if (!overrides.empty())
        throw InputError(fmt::format("{}: --set changes fields of scenes, and this is an actor; check it alone", path));
    const Actor actor = readActor(findAsset(path));
    const World world = worldOf(path, actor);
    if (quiet) return;
    for (const std::string& warning : actorWarnings(actor, world)) fmt::print("{}: warning: {}\n", path, warning);
    double mass = 0.0;
    for (const Body& body : world.bodies) mass += double{body.mass};
    fmt::print("{}: {}, particles of {:g} m, {:.4g} kg at {:g} kg/m3\n", path, contentsOf(world), actor.diameter, mass,
               world.materials[0].density);
}

int check(const std::vector<std::string>& paths, const std::vector<Override>& overrides, bool quiet)
{
    int code = EXIT_FINE;
    for (const std::string& path : paths) {
        try {
            (isActorFile(findAsset(path)) ? checkActor : checkScene)(path, overrides, quiet);
        } catch (const InputError& error) {
            // Printed here, so that one bad file does not hide faults of the next.
            tellUser(fmt::format("knuckle: {}", error.what()));
            code = EXIT_INPUT;
        }
    }
    return code;
}

}  // namespace

void addCheckCommand(CommandLine line)
{
    auto* command = line.program.add_subcommand("check",
                                                "Check scene and actor files without running them; needs no GPU");
    command->fallthrough();
    command->footer(
        "Prints a line for each scene: particles, bodies, joints, colliders, duration; for each actor its mass\n"
        "at 1000 kg/m3, and which joints turn otherwise than they say.\n"
        "Tells where animated objects pass through colliders or each other, and how far.\n"
        "Exit code 2 when one of them is wrong; all are checked.\n\nExample:\n"
        "  knuckle check assets/scenes/*.json actors/*.json actors/*.npz");
    auto paths = std::make_shared<std::vector<std::string>>();
    auto sets = std::make_shared<std::vector<std::string>>();
    command->add_option("FILE", *paths, "Scene or actor files")->required();
    command->add_option("--set", *sets, "Change a field first, as of `knuckle render`")
        ->type_name("PATH=VALUE")
        ->take_all()
        ->allow_extra_args(false);
    command->callback([=] {
        line.chosen = [=] {
            std::vector<Override> overrides;
            for (const std::string& text : *sets) overrides.push_back(parseOverride(text));
            return check(*paths, overrides, line.common.quiet);
        };
    });
}

}  // namespace knuckle
