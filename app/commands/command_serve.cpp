#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <memory>

#include "app/commands/command_options.h"
#include "app/commands/commands.h"
#include "app/files/assets.h"
#include "app/film/complete_picture.h"
#include "app/run/tell.h"
#include "app/serve/ball.h"
#include "app/serve/live_run.h"
#include "sim/base/errors.h"

namespace knuckle {

namespace {

constexpr const char* SERVE_NOTES =
    "The page shows the scene as it is simulated, no faster than time passes. Drag turns the camera, with Shift it\n"
    "moves it, the wheel goes nearer; Space pauses, S steps, R goes back to the start. One simulation, one camera: "
    "all\n"
    "who look see the same.\n\n"
    "It listens on this machine alone. From elsewhere: ssh -L 8080:127.0.0.1:8080 MACHINE, or --host with a --token,\n"
    "which is sent unencrypted.\n\n"
    "Ctrl and drag pulls a body, a click tells its name, a double click throws it.\n\n"
    "Examples:\n"
    "  knuckle serve assets/scenes/pile.json\n"
    "  knuckle serve assets/scenes/dance.json --size 640x360 --port 0\n"
    "  knuckle serve assets/scenes/dam.json --host 0.0.0.0 --token \"$(openssl rand -hex 16)\"\n"
    "  knuckle serve assets/scenes/tower.json --log tower.log\n"
    "  knuckle serve assets/scenes/tower.json --ball 0.15       throw it where the mouse is, by B\n"
    "  knuckle serve assets/scenes/tower.json --replay tower.log --hash\n\n"
    "docs/serve.md has what it answers to.";

struct ServeWords {
    std::string scene, size, quality = "draft";
    std::vector<std::string> sets;
    double ball = 0.0;  // its radius [m]; 0: none
    ServeOptions options;
};

/// @param sets on top of those of the command line.
std::unique_ptr<ServedScene> load(const ServeWords& words, const CommonOptions& common,
                                  const std::vector<std::string>& sets)
{
    std::vector<Override> overrides{{"render.quality", words.quality}};
    for (const std::string& text : words.sets) overrides.push_back(parseOverride(text));
    if (!words.size.empty()) {
        const auto [width, height] = parsePictureSize(words.size);
        overrides.push_back({"render.width", width});
        overrides.push_back({"render.height", height});
    }
    if (words.ball > 0.0) overrides.push_back(ballOf(words.ball));
    for (const std::string& text : sets) overrides.push_back(parseOverride(text, "restart: "));
    auto served = std::make_unique<ServedScene>(ServedScene{loadScene(findAsset(words.scene), overrides), {}});
    completePicture(served->scene);
    if (!common.quiet)
        for (const std::string& warning : served->scene.warnings)
            tellUser(fmt::format("knuckle: warning: {}: {}", words.scene, warning));
    served->branch = openBranch(served->scene);
    return served;
}

int serve(const ServeWords& words, const CommonOptions& common)
{
    const LoadServed loadWith = [&](const std::vector<std::string>& sets) { return load(words, common, sets); };
    if (words.options.replay.empty()) serveScene(loadWith, words.options, common);
    if (!words.options.log.empty()) throw InputError("--log: --replay makes none; leave out one of them");
    return replayChanges(loadWith, words.options, common);
}

}  // namespace

void addServeCommand(CommandLine line)
{
    auto* command = line.program.add_subcommand("serve", "Show a scene live in a browser, and steer it");
    command->fallthrough();
    command->footer(SERVE_NOTES);
    auto words = std::make_shared<ServeWords>();
    command->add_option("SCENE", words->scene, "A scene file")->required();
    command->add_option("--port", words->options.web.port, "Where to listen; 0: any port that is free [8080]")
        ->type_name("N")
        ->check(numberBetween(0, 65535).description(""));
    command->add_option("--host", words->options.web.host, "The address to listen at [127.0.0.1]")
        ->type_name("ADDRESS");
    command->add_option("--token", words->options.web.token, "A secret that the page's address has to end in")
        ->type_name("TEXT");
    command->add_option("--size", words->size, "Pixels of the picture [the scene's, 1280x720]")->type_name("WxH");
    command->add_option("--quality", words->quality, "How much work a picture is: draft, good or final [draft]")
        ->type_name("WORD")
        ->check(oneOf({"draft", "good", "final"}));
    command->add_option("--set", words->sets, "Change a field of the scene, as solver.substeps=8")
        ->type_name("PATH=VALUE")
        ->take_all()
        ->allow_extra_args(false);
    command
        ->add_option("--share", words->options.share,
                     "What pictures may take of the time of a simulation that is behind [0.05]")
        ->type_name("PART")
        ->check(numberBetween(0.01, 1.0).description(""));
    command->add_option("--ball", words->ball, "A ball of this radius to throw into the scene, by B")
        ->type_name("METRES")
        ->check(numberBetween(0.01, 10.0).description(""));
    command->add_option("--log", words->options.log, "Write all that changes the simulation, by step")
        ->type_name("FILE");
    command
        ->add_option("--replay", words->options.replay,
                     "Simulate what --log has written, without a server; exit code 4 if another state comes out")
        ->type_name("FILE");
    command->add_flag("--hash", words->options.hash, "Print the hash of the last state at the end");
    command->callback([=] { line.chosen = [=] { return serve(*words, line.common); }; });
}

}  // namespace knuckle
