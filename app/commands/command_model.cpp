#include <CLI/CLI.hpp>

#include "app/commands/commands.h"
#include "app/files/model_file.h"
#include "sim/actor/humanoid.h"

namespace knuckle {

void addModelCommand(CommandLine line)
{
    auto* command = line.program.add_subcommand("model", "Write the project's own rigged figure as binary glTF");
    command->group("");    // hidden: only for renewing assets/models
    auto output = std::make_shared<std::string>();
    command->add_option("-o,--output", *output, "Where to")->type_name("humanoid.glb")->required();
    command->callback([=] {
        line.chosen = [=] {
            writeModel(*output, makeHumanoid());
            return EXIT_FINE;
        };
    });
}

}  // namespace knuckle
